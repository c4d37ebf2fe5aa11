// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/scene/crossing.hpp>
#include <carom/scene/motion.hpp>
#include <carom/scene/prediction.hpp>

namespace carom::scene {

/// The squared gap of two spheres whose accelerations differ, as a quartic of s = t − now on [0, span], by its
/// Bernstein coefficients there, each within `error` of the true one.
struct UncertainQuartic {
  std::array<double, 5> bernstein;
  double error;
  double span;
};

[[nodiscard]] UncertainQuartic squared_gap(const Beside& pair, const Path& a, const Path& b, double span);

/// As of a quadratic: the least s in [0, span] at which it falls below 0. By halving the interval (R. T. Farouki, "The
/// Bernstein polynomial basis: a centennial retrospective", CAGD 29, 2012, §5): the quartic lies between its least and
/// its greatest coefficient.
[[nodiscard]] Crossing first_crossing(const UncertainQuartic& quartic);

}  // namespace carom::scene
