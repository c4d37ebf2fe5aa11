// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/crossing.hpp>

#include "paths.hpp"

namespace carom::scene {
namespace {

using unit::Rational;

/// c₀ + c₁ s + c₂ s², exactly.
struct ExactQuadratic {
  Rational c0, c1, c2;

  [[nodiscard]] Rational at(const Rational& s) const { return (c2 * s + c1) * s + c0; }

  /// The vertex, if it is a minimum.
  [[nodiscard]] std::optional<Rational> bottom() const {
    if (!(c2 > 0)) {
      return std::nullopt;
    }
    return -c1 / (Rational(2) * c2);
  }

  /// Whether the quadratic is negative anywhere in [0, end].
  [[nodiscard]] bool falls_before(const Rational& end) const {
    const auto vertex = bottom();
    return at(Rational(0)) < 0 || at(end) < 0 || (vertex && *vertex > 0 && *vertex < end && at(*vertex) < 0);
  }

  /// Whether the quadratic is negative anywhere from 0 on.
  [[nodiscard]] bool ever_falls() const {
    const auto vertex = bottom();
    if (vertex) {
      return at(Rational(0)) < 0 || (*vertex > 0 && at(*vertex) < 0);
    }
    return c2 < 0 || c1 < 0 || c0 < 0;
  }
};

/// The fault of a crossing of a quadratic that is not negative at 0; empty if the crossing is right or undecided.
std::string wrong_with(const Crossing& found, const ExactQuadratic& truth) {
  switch (found.decision) {
    case Decision::none:
      return truth.ever_falls() ? "it falls" : "";
    case Decision::bounded: {
      const Rational before = Rational(found.s) - Rational(found.error);
      if (before > 0 && truth.falls_before(before)) {
        return "it falls before";
      }
      // A root at the end of the bounds is allowed if the quadratic falls there.
      const Rational after = Rational(found.s) + Rational(found.error);
      const Rational instant = Rational(1).times_power_of_two(-1060);
      return truth.falls_before(after + instant) ? "" : "it falls after, or never";
    }
    case Decision::undecided:
      break;
  }
  return "";
}

ExactQuadratic exactly(const UncertainQuadratic& q) { return {Rational(q.c0), Rational(q.c1), Rational(q.c2)}; }

/// A random quadratic that lies within the error radii of q and is not negative at 0.
ExactQuadratic within(properties::Stream& stream, const UncertainQuadratic& q) {
  const auto moved = [&](double c, double e) { return Rational(c) + Rational(stream.integer(-8, 8), 8) * Rational(e); };
  ExactQuadratic truth{moved(q.c0, q.e0), moved(q.c1, q.e1), moved(q.c2, q.e2)};
  if (truth.c0 < 0) {
    truth.c0 = Rational(0);
  }
  return truth;
}

TEST(Crossing, BoundsThatOfEveryQuadraticWithinTheRadii) {
  int decided = 0;
  int crossed = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const double relative = stream.chance(3) ? 0 : stream.power_of_ten(-16, -2);
    UncertainQuadratic q{};
    q.c0 = stream.chance(8) ? 0 : std::abs(stream.signed_unit()) * stream.power_of_ten(-12, 2);
    q.c1 = stream.chance(8) ? 0 : stream.signed_unit() * stream.power_of_ten(-6, 3);
    q.c2 = stream.chance(8) ? 0 : stream.signed_unit() * stream.power_of_ten(-6, 3);
    if (stream.chance(3) && q.c0 > 0) {
      q.c2 = q.c1 * q.c1 / (4 * q.c0) * (1 + stream.signed_unit() * stream.power_of_ten(-16, -1));
    }
    q.e0 = relative * std::abs(q.c0);
    q.e1 = relative * std::abs(q.c1);
    q.e2 = relative * std::abs(q.c2);
    const Crossing found = first_crossing(q);
    decided += found.decision == Decision::undecided ? 0 : 1;
    crossed += found.decision == Decision::bounded ? 1 : 0;
    for (int i = 0; i < 4; ++i) {
      const std::string wrong = wrong_with(found, within(stream, q));
      if (!wrong.empty()) {
        FAIL() << wrong << ", seed " << seed;
      }
    }
  }
  // Some crossings are undecided: a third of the quadratics is close to a double root, and error radii go up to a
  // hundredth.
  EXPECT_GT(decided, 1200);
  EXPECT_GT(crossed, 400);
}

TEST(Crossing, OfCoefficientsWithoutRadiiIsKnownToSomeUlps) {
  properties::Stream stream = properties::stream_from(2);
  for (int i = 0; i < 1000; ++i) {
    // The discriminant D is at least c₁²/2. The residual is a few unit roundoffs u of its terms, so the error is a few
    // u s c₁/√D.
    const double c1 = -stream.between(0.5, 2);
    const double c0 = stream.between(0.1, 1);
    const double c2 = stream.signed_unit() * c1 * c1 / (8 * c0);
    const UncertainQuadratic q{c0, c1, c2, 0, 0, 0};
    const Crossing found = first_crossing(q);
    ASSERT_EQ(found.decision, Decision::bounded);
    EXPECT_EQ(wrong_with(found, exactly(q)), "");
    EXPECT_LE(found.error, 64 * roundoff * found.s);
  }
}

TEST(Crossing, OfADoubleRootIsUndecidedAndOfNoRootNone) {
  EXPECT_EQ(first_crossing({1, -2, 1, 0, 0, 0}).decision, Decision::undecided);
  EXPECT_EQ(first_crossing({1, -2, 1 + 0x1p-40, 0, 0, 0}).decision, Decision::none);
  EXPECT_EQ(first_crossing({1, -2, 1 - 0x1p-40, 0, 0, 0}).decision, Decision::bounded);
  EXPECT_EQ(first_crossing({1, -2, 1 + 0x1p-40, 0, 0, 0x1p-40}).decision, Decision::undecided);
}

TEST(Crossing, OfSpheresThatTouchIsWhetherTheyRecede) {
  EXPECT_EQ(first_crossing({0, 1, 1, 0, 0, 0}).decision, Decision::none);
  EXPECT_EQ(first_crossing({0, 0, 1, 0, 0, 0}).decision, Decision::none);
  const Crossing approaching = first_crossing({0, -1, 1, 0, 0, 0});
  ASSERT_EQ(approaching.decision, Decision::bounded);
  EXPECT_EQ(approaching.s, 0);
  EXPECT_EQ(approaching.error, 0);
}

TEST(Crossing, OfWhatRecedesIsNone) {
  EXPECT_EQ(first_crossing({1, 1, 3, 0x1p-50, 0x1p-50, 0x1p-50}).decision, Decision::none);
  EXPECT_EQ(first_crossing({1, 1, 0, 0x1p-50, 0x1p-50, 0}).decision, Decision::none);
  // The error radii leave open whether the quadratic falls at s = 0.
  EXPECT_EQ(first_crossing({0, 0x1p-51, 1, 0x1p-50, 0x1p-50, 0}).decision, Decision::undecided);
}

TEST(Crossing, OfALineIsItsRoot) {
  const Crossing found = first_crossing({3, -2, 0, 0, 0, 0});
  ASSERT_EQ(found.decision, Decision::bounded);
  EXPECT_EQ(found.s, 1.5);
  EXPECT_EQ(wrong_with(found, {Rational(3), Rational(-2), Rational(0)}), "");
  EXPECT_EQ(first_crossing({3, 0, 0, 0, 0, 0}).decision, Decision::none);
}

TEST(Crossing, OfABallThatHasBouncedIsWhereItComesDownAgain) {
  // The ball starts on the plane, so s = 0 is a root of 3 s − s². The crossing is the other root.
  const Crossing found = first_crossing({0, 3, -1, 0, 0, 0});
  ASSERT_EQ(found.decision, Decision::bounded);
  EXPECT_NEAR(found.s, 3, found.error);
  EXPECT_LE(found.error, 64 * roundoff * 3);
  // An error radius of 2⁻⁵⁰ for c₀ does not change the crossing.
  const Crossing state_at = first_crossing({0, 3, -1, 0x1p-50, 0, 0});
  ASSERT_EQ(state_at.decision, Decision::bounded);
  EXPECT_NEAR(state_at.s, 3, state_at.error);
  EXPECT_GE(state_at.error, 0x1p-50 / 3);
}

TEST(Crossing, AsBoundsOfTimeContainsTheSum) {
  properties::Stream stream = properties::stream_from(3);
  for (int i = 0; i < 1000; ++i) {
    const double now = stream.unit() * stream.power_of_ten(-3, 6);
    const Crossing crossing{Decision::bounded, stream.unit() * stream.power_of_ten(-9, 3),
                            stream.unit() * stream.power_of_ten(-18, -3)};
    const TimeBounds bounds = bounds_from(now, crossing);
    const Rational earliest = Rational(now) + Rational(crossing.s) - Rational(crossing.error);
    const Rational latest = Rational(now) + Rational(crossing.s) + Rational(crossing.error);
    EXPECT_TRUE(Rational(bounds.earliest) <= earliest || bounds.earliest == now);
    EXPECT_TRUE(Rational(bounds.latest) >= latest);
    EXPECT_GE(bounds.earliest, now);
    // The width is at most twice the error, plus the rounding of three sums.
    EXPECT_LE(bounds.latest - bounds.earliest, 2 * crossing.error + 16 * roundoff * (now + crossing.s));
  }
}

}  // namespace
}  // namespace carom::scene
