// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <carom/impulse/numbers/products.hpp>

/// Products of vectors with a small relative error in each component.
namespace carom::impulse {

/// A type with fma: a floating-point number or a pack of them.
template <class S>
concept FusesMultiplyAdd = std::is_floating_point_v<S> || requires {
  typename S::mask_type;
};

namespace detail {

/// x y + z of each lane of a pack, rounded once. The compiler makes one instruction of the loop, if the machine has
/// one. Otherwise the loop calls std::fma for each lane. Inlined in each product, these calls would double the size and
/// the compile time of the batch kernels.
template <class P>
[[nodiscard]]
#if !defined(__FMA__) && !defined(__ARM_FEATURE_FMA)
[[gnu::noinline]]
#endif
P fused_multiply_add_of_lanes(const P& x, const P& y, const P& z) {
  using Number = typename P::value_type;
  using Numbers [[gnu::vector_size(sizeof(P))]] = Number;
  const auto xs = std::bit_cast<Numbers>(x);
  const auto ys = std::bit_cast<Numbers>(y);
  const auto zs = std::bit_cast<Numbers>(z);
  Numbers result{};
  for (std::size_t lane = 0; lane < P::size(); ++lane) {
    result[lane] = std::fma(xs[lane], ys[lane], zs[lane]);
  }
  return std::bit_cast<P>(result);
}

/// x y + z, rounded once.
template <class S>
[[nodiscard]] S fused_multiply_add(const S& x, const S& y, const S& z) {
  if constexpr (std::is_floating_point_v<S>) {
    return std::fma(x, y, z);
  } else {
    return fused_multiply_add_of_lanes(x, y, z);
  }
}

/// x y − `product`, exactly, if `product` is the rounded x y (T. J. Dekker, "A floating-point technique for extending
/// the available precision", Numerische Mathematik 18, 1971). Not exact if |x| or |y| exceeds 2⁻³³ times the largest
/// number.
[[nodiscard]] inline long double error_of_product(long double x, long double y, long double product) {
  static_assert(std::numeric_limits<long double>::radix == 2);
  constexpr int half = (std::numeric_limits<long double>::digits + 1) / 2;
  constexpr long double split = static_cast<long double>(1ULL << half) + 1;
  const long double x_high = split * x - (split * x - x);
  const long double y_high = split * y - (split * y - y);
  const long double x_low = x - x_high;
  const long double y_low = y - y_high;
  return ((x_high * y_high - product) + x_high * y_low + x_low * y_high) + x_low * y_low;
}

}  // namespace detail

/// a b − c d, with an error of at most 3/2 ulps unless a product overflows or underflows (W. Kahan; C.-P. Jeannerod, N.
/// Louvet, J.-M. Muller, "Further analysis of Kahan's algorithm for the accurate computation of 2 × 2 determinants",
/// Mathematics of Computation 82, 2013). For long double, without fma, the relative error is at most 2 u with the unit
/// roundoff u (M. Cornea, J. Harrison, P. T. P. Tang; C.-P. Jeannerod, "A radix-independent error analysis of the
/// Cornea-Harrison-Tang method", ACM Transactions on Mathematical Software 42, 2016). Other types have digits to spare,
/// and evaluate the expression as written.
template <class S>
[[nodiscard]] S difference_of_products(const S& a, const S& b, const S& c, const S& d) {
  if constexpr (std::is_same_v<S, long double>) {
    const S first = a * b;
    const S second = c * d;
    return (first - second) + (detail::error_of_product(a, b, first) - detail::error_of_product(c, d, second));
  } else if constexpr (FusesMultiplyAdd<S>) {
    const S product = c * d;
    const S error_of_product = detail::fused_multiply_add<S>(-c, d, product);
    return detail::fused_multiply_add<S>(a, b, -product) + error_of_product;
  } else {
    return a * b - c * d;
  }
}

/// x × y, with each component from difference_of_products.
template <class S>
[[nodiscard]] Vector3<S> accurate_cross(const Vector3<S>& x, const std::type_identity_t<Vector3<S>>& y) {
  return {difference_of_products<S>(x[1], y[2], x[2], y[1]), difference_of_products<S>(x[2], y[0], x[0], y[2]),
          difference_of_products<S>(x[0], y[1], x[1], y[0])};
}

}  // namespace carom::impulse
