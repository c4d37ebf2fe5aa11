// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/scene/arc.hpp>
#include <carom/scene/crossing.hpp>
#include <carom/scene/prediction.hpp>

namespace carom::scene {

/// The squared gap of two spheres whose accelerations differ, as a quartic in the time s from now, for s in [0, span].
/// `bernstein` holds its Bernstein coefficients on this interval, each within `error` of the true coefficient.
struct UncertainQuartic {
  std::array<double, 5> bernstein;
  double error;
  double span;
};

[[nodiscard]] UncertainQuartic squared_gap(const RelativeState& pair, const Path& a, const Path& b, double span);

/// The first crossing in [0, span]: the least s at which the quartic falls below 0 (see `Crossing`). The search divides
/// the interval (R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective", CAGD 29, 2012, §5). On
/// each part, the least and the greatest Bernstein coefficient bound the quartic.
[[nodiscard]] Crossing first_crossing(const UncertainQuartic& quartic);

}  // namespace carom::scene
