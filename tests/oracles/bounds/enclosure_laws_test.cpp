// SPDX-License-Identifier: BSL-1.0
#include <carom/oracles/bounds/enclosure.hpp>

#include "support/number_laws.hpp"

namespace carom::unit {

template <>
struct NumberType<oracles::Enclosure> {
  using T = oracles::Enclosure;
  static T draw(properties::Stream& stream) {
    return stream.chance(9) ? T(0) : T(stream.signed_unit()) / T(stream.integer(1, 9));
  }
  static bool is_zero(const T& x) { return !(x.magnitude_below() > 0); }
  static bool same(const T& x, const T& y) {
    return x.middle() == y.middle() && x.lower_part() == y.lower_part() && x.radius() == y.radius();
  }
  static bool same_value(const T& x, const T& y) {
    return x.middle() == y.middle() && x.lower_part() == y.lower_part();
  }
  static bool agrees(const T& x, const T& y, double) { return (x - y).magnitude_below() == 0; }
  static double size(const T& x) { return x.magnitude_above(); }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Enclosure, NumberLaws, oracles::Enclosure);

}  // namespace carom::unit
