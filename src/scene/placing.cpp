// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <carom/impulse/numbers/exact_sum.hpp>
#include <carom/scene/placing.hpp>
#include <carom/scene/prediction.hpp>

namespace carom::scene {

Vector3<double> rounded_away(const Path& path, double time, const Vector3<double>& away) {
  // The roundoff of long double is at most 2⁻¹¹ of that of double.
  using Wide = long double;
  constexpr Wide wide_roundoff = std::numeric_limits<Wide>::epsilon() / 2;
  const Wide s = Wide(time) - Wide(path.start);
  Vector3<double> result;
  for (int axis = 0; axis < 3; ++axis) {
    const Wide x = path.position[axis];
    const Wide v = path.velocity[axis];
    const Wide a = path.acceleration[axis];
    const Wide half = s * a / 2;
    const Wide moved = s * (v + half);
    const Wide exact = x + moved;
    double rounded = static_cast<double>(exact);
    if (s != 0 && (v != 0 || a != 0) && away[axis] != 0) {
      const Wide bound = 8 * wide_roundoff * (std::abs(x) + std::abs(s) * (std::abs(v) + std::abs(half)));
      const bool up = away[axis] > 0;
      if (up ? Wide(rounded) < exact + bound : Wide(rounded) > exact - bound) {
        rounded = std::nextafter(rounded, up ? never : -never);
      }
    }
    result[axis] = rounded;
  }
  return result;
}

namespace {

/// The sign of the gap of two spheres at the common start of their paths. A lattice may have hundreds of thousands of
/// touching spheres. An exact sum of products is faster than the rational numbers of `sign_of_gap`.
int sign_of_gap_at_start(const Path& a, const Path& b) {
  impulse::ExactSum squared_gap;
  for (int axis = 0; axis < 3; ++axis) {
    squared_gap.add(a.position[axis], a.position[axis]);
    squared_gap.add(a.position[axis], b.position[axis], -2);
    squared_gap.add(b.position[axis], b.position[axis]);
  }
  squared_gap.add(-a.radius, a.radius);
  squared_gap.add(a.radius, b.radius, -2);
  squared_gap.add(-b.radius, b.radius);
  return squared_gap.sign();
}

template <class Other>
bool is_negative(double gap, double error, const Path& path, const Other& other, double time,
                 unsigned long long& undecided) {
  if (std::abs(gap) > error) {
    return gap < 0;
  }
  ++undecided;
  return sign_of_gap(path, other, time) < 0;
}

}  // namespace

bool overlap(const Path& a, const Path& b, double time, unsigned long long& undecided) {
  const RelativeState pair(state_at(a, time), state_at(b, time), a.radius + b.radius);
  if (a.start == time && b.start == time && std::abs(pair.squared_gap()) <= pair.squared_gap_error()) {
    ++undecided;
    return sign_of_gap_at_start(a, b) < 0;
  }
  return is_negative(pair.squared_gap(), pair.squared_gap_error(), a, b, time, undecided);
}

bool overlap(const Path& sphere, const Reach& plane, double time, unsigned long long& undecided) {
  if (time == sphere.start && plane.normal.cwiseAbs().sum() == 1 && plane.normal.cwiseAbs().maxCoeff() == 1) {
    return plane.normal.dot(sphere.position) < plane.reach;  // N·x is one coordinate or its negative
  }
  const UncertainQuadratic height = height_over(sphere, plane, time);
  return is_negative(height.c0, height.e0, sphere, plane, time, undecided);
}

Vector3<double> moved_by_ulps(const Vector3<double>& position, int k) {
  static const auto steps = [] {
    std::array<std::array<int, 3>, moves> all{};
    for (int i = 0; i < moves; ++i) {
      all[static_cast<std::size_t>(i)] = {i % 7 - 3, i / 7 % 7 - 3, i / 49 - 3};
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) {
      return x[0] * x[0] + x[1] * x[1] + x[2] * x[2] < y[0] * y[0] + y[1] * y[1] + y[2] * y[2];
    });
    return all;
  }();
  Vector3<double> moved = position;
  for (int axis = 0; axis < 3; ++axis) {
    int left = steps[static_cast<std::size_t>(k)][static_cast<std::size_t>(axis)];
    for (; left > 0; --left) {
      moved[axis] = std::nextafter(moved[axis], never);
    }
    for (; left < 0; ++left) {
      moved[axis] = std::nextafter(moved[axis], -never);
    }
  }
  return moved;
}

}  // namespace carom::scene
