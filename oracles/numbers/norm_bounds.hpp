// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include <carom/collision/expects.hpp>

namespace carom::oracles {

namespace norm_bounds {

/// A bound of the relative rounding of a sum of six squares, or of six hypotenuses (an ulp each), and of one
/// comparison.
inline constexpr double rounding = 0x1p-45;

/// Bounds between these limits are compared by squares. Underflow of squares is negligible at the smaller limit, and
/// the square of the larger limit is far from overflow.
inline constexpr double least_by_squares = 0x1p-400;
inline constexpr double largest_by_squares = 0x1p+400;

/// More than the square root of the underflow of squares.
inline constexpr double lost_by_root = 0x1p-500;

/// More than the underflow of hypotenuses.
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

/// At least ‖v‖. It is zero only if v is zero.
template <class T>
[[nodiscard]] double norm_above(std::span<const T> vector) {
  bool is_zero = true;
  const double squares = norm_bounds::sum_of_squares<double>(vector, [&](const T& component) {
    const double above = component.magnitude_above();
    is_zero = is_zero && above == 0;
    return above;
  });
  return is_zero ? 0 : std::sqrt(squares) * (1 + norm_bounds::rounding) + norm_bounds::lost_by_root;
}

/// Whether ‖v‖ ≤ bound, or nullopt if the errors do not decide it. A ≥ ‖v‖ and B ≤ ‖v‖ are computed with a relative
/// error below `rounding`. Underflow changes A and B by less than lost = `lost_by_hypotenuses`.
///
///   (1) true if A (1 + rounding) + lost ≤ bound, or A = 0;
///   (2) false if B (1 − rounding) − lost > bound;
///   (3) for a bound between `least_by_squares` and `largest_by_squares`, both tests compare squares without `lost`.
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
