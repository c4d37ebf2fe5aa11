// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include <carom/collision/expects.hpp>

namespace carom::oracles {

namespace norm_bounds {

/// An upper bound of the relative rounding error of a sum of six squares, or of six calls of hypot (an ulp each), and
/// of one comparison.
inline constexpr double rounding = 0x1p-45;

/// If `bound` of `norm_at_most_by_bounds` is between these limits, the function compares squares. The underflow of
/// squares is negligible at the smaller limit. The square of the larger limit is far from overflow.
inline constexpr double least_by_squares = 0x1p-400;
inline constexpr double largest_by_squares = 0x1p+400;

/// An upper bound of the loss of hypotenuses by underflow.
inline constexpr double lost_by_hypotenuses = 0x1p-1070;

template <class S, class T, class Size>
[[nodiscard]] S sum_of_squares(std::span<const T> vector, const Size& size) {
  S sum(0);
  for (const T& component : vector) {
    const S x = size(component);
    sum += x * x;
  }
  return sum;
}

}  // namespace norm_bounds

/// Whether ‖v‖ ≤ bound, or nullopt if the errors do not decide it. A is the computed norm of the upper bounds of |v_i|,
/// and B that of the lower bounds. Each has a relative rounding error below ρ = `rounding`, and loses less than
/// δ = `lost_by_hypotenuses` to underflow.
///
///   (1) true if A (1 + ρ) + δ ≤ bound, or A = 0;
///   (2) false if B (1 − ρ) − δ > bound;
///   (3) if `bound` is between `least_by_squares` and `largest_by_squares`, (1) and (2) compare squares, without δ.
///
/// Precondition: the bound is finite and not negative.
template <class T>
[[nodiscard]] std::optional<bool> norm_at_most_by_bounds(std::span<const T> vector, double bound) {
  CAROM_EXPECTS(std::isfinite(bound) && bound >= 0, bound);
  const auto above_of = [](const T& component) { return component.magnitude_above(); };
  const auto below_of = [](const T& component) { return component.magnitude_below(); };
  if (bound >= norm_bounds::least_by_squares && bound <= norm_bounds::largest_by_squares) {
    if (norm_bounds::sum_of_squares<double>(vector, above_of) * (1 + norm_bounds::rounding) <=
        bound * bound * (1 - norm_bounds::rounding)) {
      return true;
    }
    if (norm_bounds::sum_of_squares<double>(vector, below_of) * (1 - norm_bounds::rounding) >
        bound * bound * (1 + norm_bounds::rounding)) {
      return false;
    }
    return std::nullopt;
  }
  double above = 0;
  double below = 0;
  for (const T& component : vector) {
    above = std::hypot(above, above_of(component));
    below = std::hypot(below, below_of(component));
  }
  if (above == 0 || above * (1 + norm_bounds::rounding) + norm_bounds::lost_by_hypotenuses <= bound) {
    return true;
  }
  if (below * (1 - norm_bounds::rounding) - norm_bounds::lost_by_hypotenuses > bound) {
    return false;
  }
  return std::nullopt;
}

}  // namespace carom::oracles
