// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/vector.hpp>

namespace carom::scene {

/// The height of a point along a direction [m], and its speed along it [m/s].
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
  double lost = 0;       // makes h(0) the certified gap [m]
  double curvature = 0;  // ≥ 0 [m/s²]
};

/// A time of at most `limit` [s], up to which h stays at least `least`; 0 if h(0) ≤ least. h is concave, so the ends of
/// chords approach the time of h = least from below.
[[nodiscard]] double time_open(const GapBound& bound, double least, double limit);

/// The speed at which the gap is certain to open at first [m/s]: the least speed of A's points minus the greatest speed
/// of B's. Only A's points within `band` [m] of its lowest point count, and B's within `band` of its highest.
[[nodiscard]] double opening_speed(const GapBound& bound, double band);

}  // namespace carom::scene
