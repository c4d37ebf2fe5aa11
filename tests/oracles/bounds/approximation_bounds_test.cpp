// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/oracles/numbers/approximation.hpp>

#include "covers.hpp"
#include "support/exact.hpp"
#include "support/rounding_count.hpp"

/// Checks the constants and the inequalities (1) to (5) of oracles/numbers/approximation.hpp. That header defines the
/// symbols.
namespace carom::bounds {
namespace {

namespace approximation = oracles::approximation;
using oracles::Approximation;
using oracles::Rational;

/// An input of size 3, with which no product is exact.
const RoundingCount any_radius = RoundingCount::input(3);

TEST(ApproximationBounds, RoundUpByMoreThanTheirRoundings) {
  const int of_sum = approximation::radius_of_sum(any_radius, any_radius, any_radius).roundings() + 1;
  const int of_product =
      approximation::radius_of_product(any_radius, any_radius, any_radius, any_radius, any_radius).roundings();
  // In (4), the rounded quotient q replaces x̂ / ŷ. As |x̂ / ŷ| ≤ (1 + u) |q|, this adds a rounding.
  const int of_quotient =
      approximation::radius_of_quotient(any_radius, any_radius, any_radius, any_radius).roundings() + 1;
  // In (5), the rounded root ẑ replaces √x̂. As ẑ ≤ (1 + u) √x̂, this adds a rounding.
  const int of_root = approximation::radius_of_root(any_radius, any_radius).roundings() + 1;
  const int of_size = approximation::above(any_radius, any_radius).roundings();
  const int most = std::max({of_sum, of_product, of_quotient, of_root, of_size});
  EXPECT_GE(most, 6);
  EXPECT_TRUE(covers(approximation::up - 1, most * u / (1 - most * u), 64));
  EXPECT_TRUE(covers(1 - approximation::down, approximation::below(any_radius, any_radius).roundings() * u, 128));
}

/// By underflow, each operation on a bound loses at most half the least number. No formula has more operations than the
/// formula for a product.
TEST(ApproximationBounds, HaveALeastThatCoversUnderflow) {
  constexpr int operations = 8;
  EXPECT_GE(approximation::least, operations * 0x1p-1074 / 2);
  EXPECT_GE(approximation::least_number, 0x1p-1074);
}

testing::AssertionResult contains_quotients(const Approximation& x, const Approximation& y) {
  const Approximation q = x / y;
  for (const int of_x : {-1, 1}) {
    for (const int of_y : {-1, 1}) {
      const Rational numerator = Rational(x.middle()) + of_x * Rational(x.radius());
      const Rational denominator = Rational(y.middle()) + of_y * Rational(y.radius());
      if (abs(numerator / denominator - Rational(q.middle())) > Rational(q.radius())) {
        return testing::AssertionFailure()
               << x.middle() << " / (" << y.middle() << " ± " << y.radius() << ") is off by "
               << to_double(abs(numerator / denominator - Rational(q.middle()))) << ", more than " << q.radius();
      }
    }
  }
  return testing::AssertionSuccess();
}

/// For divisors near zero, |q| r_y underflows. The divisor |ŷ| − r_y may be as small as 2⁻¹⁰⁴⁰, so the division
/// enlarges the loss.
TEST(ApproximationBounds, ContainQuotientsWhoseBoundUnderflows) {
  int tried = 0;
  for (int k = 1; k <= 40; ++k) {
    for (int bits = 2; bits <= 40; bits += 2) {
      const double y = 0x1p-1000 * (1 + std::ldexp(1.0, -bits));
      const Approximation divisor = Approximation(y).widened_by(0x1p-1000);
      const Approximation x(k * 0x1p-1074);
      if (divisor.magnitude_below() > 0) {
        ++tried;
        EXPECT_TRUE(contains_quotients(x, divisor)) << k << ' ' << bits;
      }
    }
  }
  EXPECT_GT(tried, 700);
}

/// Checks inequalities (1) to (4) on numbers at the ends of their radii.
TEST(ApproximationBounds, HoldAtTheEndsOfTheRadii) {
  properties::Stream stream = properties::stream_from(51);
  for (int i = 0; i < 4000; ++i) {
    const auto draw = [&] {
      const double middle = stream.signed_unit() * stream.power_of_two(-30, 30);
      return Approximation(middle).widened_by(std::abs(middle) * stream.power_of_two(-60, -1));
    };
    const Approximation x = draw();
    const Approximation y = draw();
    const Rational exact_x = Rational(x.middle()) + (stream.chance(2) ? 1 : -1) * Rational(x.radius());
    const Rational exact_y = Rational(y.middle()) + (stream.chance(2) ? 1 : -1) * Rational(y.radius());
    const auto contains = [&](const Approximation& z, const Rational& exact) {
      return abs(exact - Rational(z.middle())) <= Rational(z.radius());
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
