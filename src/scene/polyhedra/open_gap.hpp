// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/vector.hpp>

namespace carom::scene {

/// A point along a direction: where it is and how fast it goes [m, m/s].
struct MovingPoint {
  double height;
  double speed;
};

/// A lower bound of the gap between two sets of points as time goes on:
/// h(Δ) = min (height + speed Δ) over A − max (height + speed Δ) over B − lost − ½ curvature Δ².
struct GapBound {
  std::vector<MovingPoint> a;
  std::vector<MovingPoint> b;
  double lost = 0;       // [m]
  double curvature = 0;  // ≥ 0 [m/s²]
};

/// A time up to which h stays at least `least`, and no longer than `limit`: h is concave, so a chord lies below it, and
/// the ends of chords come to where h = least from before it. 0 where h(0) ≤ least.
[[nodiscard]] double time_open(const GapBound& bound, double least, double limit);

/// How fast the gap is certain to open at first: the least speed of A's points less the greatest of B's, of those
/// within `band` of the foremost [m/s].
[[nodiscard]] double opening_speed(const GapBound& bound, double band);

}  // namespace carom::scene
