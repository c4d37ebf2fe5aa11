// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <carom/scene/polyhedra/gap_bound.hpp>

namespace carom::scene {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Value {
  double gap;
  double slope;
};

Value value_at(const GapBound& bound, double time) {
  Value a{infinity, 0};
  for (const MovingPoint& point : bound.a) {
    const double height = point.height + point.speed * time;
    if (height < a.gap) {
      a = {height, point.speed};
    }
  }
  Value b{-infinity, 0};
  for (const MovingPoint& point : bound.b) {
    const double height = point.height + point.speed * time;
    if (height > b.gap) {
      b = {height, point.speed};
    }
  }
  return {a.gap - b.gap - bound.lost - bound.curvature * time * time / 2, a.slope - b.slope - bound.curvature * time};
}

}  // namespace

double time_open(const GapBound& bound, double least, double limit) {
  double open = 0;
  double excess = value_at(bound, 0).gap - least;
  if (!(excess > 0)) {
    return 0;
  }
  Value last = value_at(bound, limit);
  double closed = limit;
  if (last.gap >= least) {
    return limit;
  }
  constexpr int most_rounds = 30;  // about five suffice
  for (int round = 0; round < most_rounds && closed - open > 1e-3 * open; ++round) {
    // If h (gap_bound.hpp) is linear, h at the end of the whole chord is `least` up to rounding, perhaps less. So the
    // search shortens the chord slightly, and more if necessary.
    const double whole = (closed - open) * (excess / (excess + (least - last.gap)));
    double chord = open + whole * (1 - 0x1p-30);
    double excess_there = value_at(bound, chord).gap - least;
    if (!(excess_there >= 0)) {
      chord = open + whole * (1 - 0x1p-8);
      excess_there = value_at(bound, chord).gap - least;
    }
    if (!(chord > open) || !(excess_there >= 0)) {
      break;
    }
    open = chord;
    excess = excess_there;
    // A tangent lies above the concave h. So h is at most `least`, up to rounding, where the tangent falls to `least`.
    const double tangent = closed + (last.gap - least) / -last.slope;
    if (last.slope < 0 && tangent > open && tangent < closed) {
      const Value there = value_at(bound, tangent);
      if (there.gap < least) {
        closed = tangent;
        last = there;
      } else {
        open = tangent;
        break;
      }
    }
  }
  return open;
}

double opening_speed(const GapBound& bound, double band) {
  double lowest = infinity;
  for (const MovingPoint& point : bound.a) {
    lowest = std::min(lowest, point.height);
  }
  double highest = -infinity;
  for (const MovingPoint& point : bound.b) {
    highest = std::max(highest, point.height);
  }
  double slowest = infinity;
  for (const MovingPoint& point : bound.a) {
    slowest = point.height <= lowest + band ? std::min(slowest, point.speed) : slowest;
  }
  double fastest = -infinity;
  for (const MovingPoint& point : bound.b) {
    fastest = point.height >= highest - band ? std::max(fastest, point.speed) : fastest;
  }
  return slowest - fastest;
}

}  // namespace carom::scene
