// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/vector.hpp>

namespace carom::scene {

/// The height [m] and the speed [m/s] of a point along a direction.
struct MovingPoint {
  double height;
  double speed;
};

/// A lower bound of the gap between two sets of points, A and B, after the time Δ:
///
///   h(Δ) = min (height + speed Δ) over A − max (height + speed Δ) over B − lost − ½ curvature Δ².
struct GapBound {
  std::vector<MovingPoint> a;
  std::vector<MovingPoint> b;
  double lost = 0;       // chosen so that h(0) is the certified gap [m]
  double curvature = 0;  // ≥ 0 [m/s²]
};

/// A time of at most `limit` [s] up to which h ≥ least; 0 if h(0) ≤ least. h is concave and lies above its chords. So a
/// search along chords approaches the time of h = least from below.
[[nodiscard]] double time_open(const GapBound& bound, double least, double limit);

/// The speed at which the gap certainly opens at Δ = 0 [m/s]: the least speed of A's points minus the greatest speed of
/// B's points. Only points of A within `band` [m] of A's lowest point count, and points of B within `band` of B's
/// highest.
[[nodiscard]] double opening_speed(const GapBound& bound, double band);

}  // namespace carom::scene
