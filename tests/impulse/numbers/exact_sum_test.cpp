// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include <carom/impulse/numbers/exact_sum.hpp>

#include "support/exact.hpp"

namespace carom::impulse {
namespace {

using unit::Rational;
using unit::sign_of;

/// A random finite double, possibly subnormal, with an exponent from `least` to `most`.
double draw(properties::Stream& stream, int least, int most) {
  return std::ldexp(stream.between(-1, 1), stream.integer(least, most));
}

void compare(int least, int most) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    properties::Stream stream = properties::case_stream(unit::seed, "exact_sum", i);
    ExactSum sum;
    Rational exact(0);
    const int terms = stream.integer(1, 40);
    std::array<double, 3> last{};
    for (int t = 0; t < terms; ++t) {
      last = {draw(stream, least, most), draw(stream, least, most), t % 3 == 0 ? 1 : draw(stream, least, most)};
      const int times = t % 2 == 0 ? 1 : -1;
      sum.add(times * last[0], last[1], last[2]);
      exact += times * Rational(last[0]) * Rational(last[1]) * Rational(last[2]);
    }
    EXPECT_EQ(sum.sign(), sign_of(exact)) << i;
    const double approximately = sum.approximately();
    if (std::isfinite(approximately) && std::abs(approximately) > std::numeric_limits<double>::min()) {
      const Rational error = Rational(approximately) - exact;
      EXPECT_LE((error < 0 ? -error : error), Rational(std::ldexp(1.0, -50)) * (exact < 0 ? -exact : exact)) << i;
    }
  }
}

TEST(ExactSum, IsThatOfRationals) { compare(-40, 40); }

TEST(ExactSum, NeitherOverflowsNorUnderflows) { compare(-1074, 1023); }

TEST(ExactSum, SeesTheLastBitBesideTheFirst) {
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const int sign : {-1, 1}) {
    ExactSum sum;
    for (int i = 0; i < 1000; ++i) {
      sum.add(most, most, most);
    }
    EXPECT_EQ(sum.sign(), 1);
    EXPECT_EQ(sum.approximately(), std::numeric_limits<double>::infinity());
    sum.add(sign * least, least, least);
    for (int i = 0; i < 1000; ++i) {
      sum.add(-most, most, most);
    }
    EXPECT_EQ(sum.sign(), sign);
    EXPECT_EQ(sum.approximately(), 0);  // 2⁻³²²² is below every double
    sum.add(-sign * least, least, least);
    EXPECT_EQ(sum.sign(), 0);
  }
}

TEST(ExactSum, OfNothingIsZero) {
  EXPECT_EQ(ExactSum().sign(), 0);
  EXPECT_EQ(ExactSum().approximately(), 0);
}

}  // namespace
}  // namespace carom::impulse
