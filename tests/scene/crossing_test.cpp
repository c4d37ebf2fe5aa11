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

TEST(Crossing, HasBoundsThatContainTheRootOfEveryQuadraticWithinTheRadii) {
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

TEST(Crossing, OfExactCoefficientsIsAccurateToSomeUlps) {
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

TEST(Crossing, OfAKnownQuadraticIsItsRootOrIsOpenWithinTheRadii) {
  struct Known {
    const char* what;
    UncertainQuadratic q;
    Decision decision;
    double s = 0;
    double greatest_error = 0;
  };
  const double ulps = 64 * roundoff;
  for (const Known& known : {
           Known{"a double root", {1, -2, 1, 0, 0, 0}, Decision::undecided},
           {"no root", {1, -2, 1 + 0x1p-40, 0, 0, 0}, Decision::none},
           {"nearly a double root", {1, -2, 1 - 0x1p-40, 0, 0, 0}, Decision::bounded, 1 - 0x1p-20, 0x1p-20},
           {"perhaps no root", {1, -2, 1 + 0x1p-40, 0, 0, 0x1p-40}, Decision::undecided},
           {"spheres touch and recede", {0, 1, 1, 0, 0, 0}, Decision::none},
           {"spheres touch", {0, 0, 1, 0, 0, 0}, Decision::none},
           {"spheres touch and approach", {0, -1, 1, 0, 0, 0}, Decision::bounded},
           {"spheres recede", {1, 1, 3, 0x1p-50, 0x1p-50, 0x1p-50}, Decision::none},
           {"a sphere recedes from a plane", {1, 1, 0, 0x1p-50, 0x1p-50, 0}, Decision::none},
           {"perhaps falls at 0", {0, 0x1p-51, 1, 0x1p-50, 0x1p-50, 0}, Decision::undecided},
           {"a line", {3, -2, 0, 0, 0, 0}, Decision::bounded, 1.5, ulps},
           {"a constant", {3, 0, 0, 0, 0, 0}, Decision::none},
           // A ball has just bounced off a plane, and 0 is a root of 3 s − s². The crossing is the other root.
           {"a ball comes down again", {0, 3, -1, 0, 0, 0}, Decision::bounded, 3, 3 * ulps},
           {"a ball comes down again, perhaps from below", {0, 3, -1, 0x1p-50, 0, 0}, Decision::bounded, 3, 3 * ulps},
       }) {
    const Crossing found = first_crossing(known.q);
    EXPECT_EQ(found.decision, known.decision) << known.what;
    EXPECT_NEAR(found.s, known.s, found.error) << known.what;
    EXPECT_LE(found.error, known.greatest_error) << known.what;
  }
}

TEST(TimeBounds, OfACrossingContainItWithItsError) {
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
