// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <carom/impulse/numbers/double_double.hpp>
#include <carom/oracles/bounds/enclosure.hpp>

#include "covers.hpp"
#include "support/exact.hpp"
#include "support/rounding_count.hpp"

/// Checks the constants of oracles/bounds/enclosure.hpp and src/impulse/numbers/double_double.hpp. Tests compare the
/// cited bounds of double-double operations with ℚ, and count the roundings of composed operations.
namespace carom::bounds {
namespace {

namespace enclosure = oracles::enclosure;
using impulse::DoubleDouble;
using oracles::Enclosure;
using oracles::Rational;

const RoundingCount any_part = RoundingCount::input(3);

/// The inputs of the formulas for radii count as exact, because `above` rounds them up first.
TEST(EnclosureBounds, RoundUpByMoreThanTheirRoundings) {
  const int of_sum = enclosure::radius_of_result(any_part + any_part, any_part, any_part, 3).roundings();
  const int of_product =
      enclosure::radius_of_result(enclosure::radius_of_product(any_part, any_part, any_part, any_part), any_part,
                                  any_part, 3)
          .roundings();
  const int of_quotient = enclosure::radius_of_quotient(any_part, any_part, any_part, any_part, any_part).roundings();
  const int of_root = enclosure::radius_of_root(any_part, any_part, any_part).roundings();
  const int of_size = enclosure::above(any_part, any_part, any_part).roundings();
  EXPECT_TRUE(covers(enclosure::up - 1, std::max({of_sum, of_product, of_quotient, of_root, of_size}) * u, 8));
  EXPECT_TRUE(covers(1 - enclosure::down, enclosure::below(any_part, any_part, any_part).roundings() * u, 16));
}

/// Let z be the computed product, and p the exact product. Then |z − p| ≤ 7u² |p|, and |p| ≤ |z| / (1 − 7u²). The
/// computed radius 16u² |z| covers this error.
TEST(EnclosureBounds, CoverTheRoundingOfDoubleDouble) {
  constexpr double of_product = 7 * u * u;
  EXPECT_TRUE(covers(enclosure::rounding, of_product / (1 - of_product) / (1 - 4 * u), 4));
}

/// A product or quotient takes fewer than 2⁶ operations. By underflow, each operation loses at most the least number,
/// 2⁻¹⁰⁷⁴.
TEST(EnclosureBounds, HaveALeastThatCoversUnderflow) {
  EXPECT_GE(enclosure::least, 0x1p6 * 0x1p-1074);
  // The last bit of a long double of size `least` is in the range of binary64.
  EXPECT_GE(enclosure::least, 0x1p-1074 * 0x1p64);
}

/// Numbers for which double-double errors are near their bounds.
DoubleDouble adversarial(properties::Stream& stream) {
  const std::array<double, 5> highs{1 + 0x1p-52, 2 - 0x1p-52, 1 + 0x1p-26, 1.5 - 0x1p-52, stream.between(1, 2)};
  const std::array<double, 5> lows{0x1p-53 * (1 - 0x1p-53), -0x1p-53 * (1 - 0x1p-52), 0x1p-54 * (2 - 0x1p-51), 0,
                                   0x1p-53 * stream.between(-1, 1)};
  const double high = highs[static_cast<std::size_t>(stream.integer(0, 4))] * (stream.chance(2) ? 1 : -1);
  const double low = lows[static_cast<std::size_t>(stream.integer(0, 4))];
  // The sum normalises the parts, because high + low may round to another number than `high`.
  return (DoubleDouble(high) + DoubleDouble(low)) * DoubleDouble(stream.power_of_two(-30, 30));
}

Rational exact(const DoubleDouble& x) { return Rational(x.high()) + Rational(x.low()); }

Enclosure enclosed(const DoubleDouble& x) { return Enclosure(x.high()) + Enclosure(x.low()); }

Rational exact(const Enclosure& x) { return Rational(x.middle()) + Rational(x.lower_part()); }

struct Worst {
  double sum = 0;
  double product = 0;
  double quotient = 0;
};

template <class T, class Make>
Worst worst_errors(const Make& make) {
  Worst worst;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    properties::Stream stream = properties::case_stream(unit::seed, "double-double bounds", i);
    const DoubleDouble first = adversarial(stream);
    const DoubleDouble drawn = adversarial(stream);
    // Sometimes y is nearly −x, so that the sum cancels.
    const DoubleDouble second =
        i % 3 == 0 ? -first * (DoubleDouble(1) + DoubleDouble(stream.power_of_two(-100, -40))) : drawn;
    const T x = make(first);
    const T y = make(second);
    const auto note = [](double& most, const Rational& computed, const Rational& right) {
      if (right != 0) {
        most = std::max(most, to_double(abs((computed - right) / right)) / (u * u));
      }
    };
    note(worst.sum, exact(x + y), exact(x) + exact(y));
    note(worst.product, exact(x * y), exact(x) * exact(y));
    note(worst.quotient, exact(x / y), exact(x) / exact(y));
  }
  return worst;
}

TEST(EnclosureBounds, KeepToTheTheoremOnDoubleDouble) {
  const Worst by_fma = worst_errors<DoubleDouble>([](const DoubleDouble& x) { return x; });
  const Worst by_splitting = worst_errors<Enclosure>([](const DoubleDouble& x) { return enclosed(x); });
  for (const Worst& worst : {by_fma, by_splitting}) {
    EXPECT_TRUE(covers(3 / (1 - 4 * u), worst.sum, 2));
    EXPECT_TRUE(covers(7, worst.product, 2));
  }
  EXPECT_TRUE(covers(15 + 56 * u, by_fma.quotient, 4));
  EXPECT_LE(by_splitting.quotient, enclosure::rounding / (u * u));
}

/// Checks inequalities (1) to (3) of enclosure.hpp on numbers at the ends of their radii.
TEST(EnclosureBounds, HoldAtTheEndsOfTheRadii) {
  properties::Stream stream = properties::stream_from(52);
  for (int i = 0; i < 4000; ++i) {
    const auto draw = [&] {
      const Enclosure middle = enclosed(adversarial(stream));
      return middle.widened_by(middle.magnitude_above() * stream.power_of_two(-110, -1));
    };
    const Enclosure x = draw();
    const Enclosure y = draw();
    const Rational exact_x = exact(x) + (stream.chance(2) ? 1 : -1) * Rational(x.radius());
    const Rational exact_y = exact(y) + (stream.chance(2) ? 1 : -1) * Rational(y.radius());
    const auto contains = [&](const Enclosure& z, const Rational& right) {
      return abs(right - exact(z)) <= Rational(z.radius());
    };
    EXPECT_TRUE(contains(x + y, exact_x + exact_y)) << i;
    EXPECT_TRUE(contains(x - y, exact_x - exact_y)) << i;
    EXPECT_TRUE(contains(x * y, exact_x * exact_y)) << i;
    if (y.magnitude_below() > 0) {
      EXPECT_TRUE(contains(x / y, exact_x / exact_y)) << i;
    }
  }
}

}  // namespace
}  // namespace carom::bounds
