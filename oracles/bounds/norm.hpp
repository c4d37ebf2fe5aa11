// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>

#include <carom/collision/outcome.hpp>

namespace carom::oracles {

/// Sums of squares between these limits keep their digits. A square loses at most 2⁻¹⁰⁷⁵ to underflow, a negligible
/// part of the smaller limit. The larger limit is far from overflow.
inline constexpr double smallest_sum_of_squares = 0x1p-900;
inline constexpr double largest_sum_of_squares = 0x1p+900;

/// √(Σ number(i)²) over i < count, rounded, for numbers of any size.
template <class Number>
[[nodiscard]] auto root_of_squares(std::size_t count, const Number& number) {
  using S = decltype(number(0));
  S squares(0);
  for (std::size_t i = 0; i < count; ++i) {
    const S x = number(i);
    squares += x * x;
  }
  using std::hypot;
  using std::sqrt;
  if (squares >= S(smallest_sum_of_squares) && squares <= S(largest_sum_of_squares)) {
    return sqrt(squares);
  }
  S norm(0);
  for (std::size_t i = 0; i < count; ++i) {
    const S x = number(i);
    norm = x == 0 ? norm : hypot(norm, x);
  }
  return norm;
}

/// ‖v‖, rounded.
template <class S>
[[nodiscard]] S norm_of(const Vector3<S>& v) {
  return root_of_squares(3, [&](std::size_t i) { return v[static_cast<Eigen::Index>(i)]; });
}

/// The lengths of the four vectors of an outcome, rounded.
[[nodiscard]] inline PerVector<double> norms_of(const Outcome<double>& outcome) {
  return {norm_of(outcome.a.velocity), norm_of(outcome.a.angular_velocity), norm_of(outcome.b.velocity),
          norm_of(outcome.b.angular_velocity)};
}

}  // namespace carom::oracles
