// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/impulse/numbers/double_double.hpp>

#include "support/number_laws.hpp"

namespace carom::unit {

/// Each side of a law of number_laws.hpp has at most twelve operations. The relative error of an operation is below
/// 16u², with u² = 2⁻¹⁰⁶ (double_double.hpp).
template <>
struct NumberType<impulse::DoubleDouble> {
  using T = impulse::DoubleDouble;
  static T draw(properties::Stream& stream) {
    return stream.chance(9) ? T(0) : T(stream.signed_unit()) / T(stream.integer(1, 9));
  }
  static bool is_zero(const T& x) { return x == T(0); }
  static bool same(const T& x, const T& y) { return x == y; }
  static bool same_value(const T& x, const T& y) { return same(x, y); }
  static bool agrees(const T& x, const T& y, double terms) {
    return std::abs(static_cast<double>(x - y)) <= 2 * 12 * 16 * 0x1p-106 * terms;
  }
  static double size(const T& x) { return std::abs(static_cast<double>(x)); }
};

INSTANTIATE_TYPED_TEST_SUITE_P(DoubleDouble, NumberLaws, impulse::DoubleDouble);

}  // namespace carom::unit
