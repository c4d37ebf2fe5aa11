// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/laws/rough.hpp>
#include <carom/oracles/truths/models.hpp>

#include "support/exact.hpp"
#include "support/message_of.hpp"

/// The truth (exact answer) of the law `rough` is F = (1 + ε) P_I + κ D with D = P_II − P_I. The frictionless impulse
/// P_I stops the approach, and P_II stops the contact point. κ is the share of friction, from 0 to 1 + e_t.
namespace carom::oracles {
namespace {

using unit::ratio;
using unit::same;

/// K = diag(3, 1, 3), P_I = (0, 4, 0) and D = (1, 0, 0). With e_t = 1/2, whole friction gives F = (3/2, 6, 0).
Collision rough_ball(double friction) {
  Collision c = unit::ball_on_a_plane(0.5, friction);
  c.tangential_restitution = 0.5;
  return c;
}

/// F lies on the surface: μ · 6 = 3/2.
TEST(Rough, SticksIfFrictionSuffices) {
  const ExactCase exact_case(rough_ball(0.25));
  EXPECT_EQ(exact_case.branch(Law::rough), Branch::inside_cone);
  const Truth<Rational>& truth = exact_case.truth(Law::rough);
  EXPECT_TRUE(same(truth.impulse, unit::ExactVector(ratio(3, 2), 6, 0)));
  EXPECT_TRUE(same(truth.outcome.a.velocity, unit::ExactVector(ratio(-3, 2), 2, 0)));
  EXPECT_TRUE(same(truth.outcome.a.angular_velocity, unit::ExactVector(0, 0, 3)));
}

TEST(Rough, SlidesIfFrictionDoesNotSuffice) {
  const ExactCase exact_case(rough_ball(0.125));
  EXPECT_EQ(exact_case.branch(Law::rough), Branch::on_cone);
  const Truth<Radical>& truth = exact_case.truth_on_cone(Law::rough);
  EXPECT_EQ(truth.impulse[0], Radical(ratio(3, 4)));
  EXPECT_EQ(truth.impulse[1], Radical(6));
  EXPECT_EQ(truth.outcome.a.velocity[0], Radical(ratio(-9, 4)));
  EXPECT_EQ(truth.outcome.a.angular_velocity[2], Radical(ratio(3, 2)));
}

class CertifiedRough : public testing::Test {
 protected:
  CertifiedRough() {
    const Vector3<Rational> stop = -relative_velocity<Rational>(exact, unchanged(exact));
    parts = {after({0, -stop[1] * -1, 0}), after(Sticking::impulse_for<Rational>(exact, stop, nullptr)),
             Rational(3, 4)};
  }
  [[nodiscard]] Outcome<Rational> after(const Vector3<Rational>& impulse) const {
    return sum(unchanged(exact), response<Rational>(exact, impulse));
  }
  /// The part of the law that the certificate of the impulse (friction, 6, 0) misses.
  [[nodiscard]] std::string missed_by(const Rational& friction) const {
    const std::string message = unit::message_of<JudgeError>([&] {
      certify_rough(exact, after({friction, Rational(6), Rational(0)}), parts);
    });
    return message.substr(std::min(message.size(), std::string("the truth of `rough` does not satisfy ").size()));
  }

  BasicCollision<Rational> exact = lift(unit::ball_on_a_plane(0.5, 0.125));
  RoughParts<Rational> parts;
};

TEST_F(CertifiedRough, IsTheTruth) { EXPECT_EQ(missed_by(Rational(3, 4)), ""); }

TEST_F(CertifiedRough, IsTheCombinationInEachComponent) {
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      Outcome<Rational> wrong = after({Rational(3, 4), Rational(6), Rational(0)});
      (*vectors(wrong)[k])[i] += 1;
      EXPECT_THROW(certify_rough(exact, wrong, parts), JudgeError) << name_of(k) << '[' << i << ']';
    }
  }
}

/// The impulse (−3/4, 6, 0) lies on the cone's surface, too.
TEST_F(CertifiedRough, HasTheShareOfFrictionThatTheConePermits) {
  for (const auto& [share, missed] : {std::pair(Rational(1), "the friction cone"),
                                      {Rational(1, 2), "its share of friction"},
                                      {Rational(-3, 4), "its share of friction"}}) {
    parts.friction_share = share;
    EXPECT_EQ(missed_by(share), missed);
  }
  parts.friction_share = Rational(3, 4);
  exact.tangential_restitution = Rational(-1, 2);
  EXPECT_EQ(missed_by(Rational(3, 4)), "its share of friction") << "more than the whole";
}

TEST_F(CertifiedRough, IsMadeOfTheAnswersOfItsLaws) {
  parts.point_stopped.a.velocity[0] += 1;
  EXPECT_EQ(missed_by(Rational(3, 4)), "the angular momentum of A");
}

/// The enclosed truth of a rough ball, and the check of its definition.
struct EnclosedRough {
  explicit EnclosedRough(double friction)
      : exact_case(rough_ball(friction)),
        impulses(exact_case.enclosed(), nullptr),
        truth(exact_case.enclosed_truth(Law::rough).outcome) {
    parts = {after(impulses.stops_approach), after(impulses.stops_point), share()};
  }
  [[nodiscard]] Enclosure share() const {
    return Rough::friction_share<Enclosure>(exact_case.enclosed(), impulses.stops_approach, impulses.difference(),
                                            exact_case.branch(Law::rough));
  }
  [[nodiscard]] Outcome<Enclosure> after(const Vector3<Enclosure>& impulse) const {
    return sum(unchanged(exact_case.enclosed()), response<Enclosure>(exact_case.enclosed(), impulse));
  }
  [[nodiscard]] std::string refuted(const Outcome<Enclosure>& outcome) const {
    const char* const name = first_refuted_of_rough(exact_case.collision(), exact_case.enclosed(), outcome, parts);
    return name == nullptr ? "" : name;
  }
  /// The refuted condition if the share of friction is this many times the right one.
  [[nodiscard]] std::string refuted_with_share(double factor) {
    parts.friction_share = share() * Enclosure(factor);
    return refuted(after(Rough::combined<Enclosure>(exact_case.enclosed(), impulses.stops_approach,
                                                    impulses.difference(), parts.friction_share)));
  }

  ExactCase exact_case;
  detail::RoughImpulses<Enclosure> impulses;
  Outcome<Enclosure> truth;
  RoughParts<Enclosure> parts;
};

/// F has the whole share of friction inside the cone and on its surface, and a smaller share on its surface.
constexpr double frictions[]{0.5, 0.25, 0.125};

/// An enclosure has some 100 bits.
TEST(EnclosedRough, RefutesASmallErrorOfEachComponent) {
  for (const double friction : frictions) {
    EnclosedRough rough(friction);
    EXPECT_EQ(rough.refuted(rough.truth), "");
    for (const OutcomeVector k : all_outcome_vectors) {
      for (int i = 0; i < 3; ++i) {
        Outcome<Enclosure> wrong = rough.truth;
        (*vectors(wrong)[k])[i] += Enclosure(0x1p-70);
        EXPECT_EQ(rough.refuted(wrong), "the combination of its parts") << name_of(k) << '[' << i << ']';
      }
    }
    rough.parts.point_stopped.a.velocity[0] += Enclosure(0x1p-70);
    EXPECT_EQ(rough.refuted(rough.truth), "the angular momentum of A") << friction;
  }
}

TEST(EnclosedRough, RefutesAnotherShareOfFriction) {
  for (const double friction : frictions) {
    EXPECT_EQ(EnclosedRough(friction).refuted_with_share(1 - 0x1p-50), "its share of friction") << friction;
    const bool is_inside = friction == frictions[0];
    EXPECT_EQ(EnclosedRough(friction).refuted_with_share(1 + 0x1p-50),
              is_inside ? "its share of friction" : "the friction cone")
        << friction;
  }
}

/// A contact that slips with (1, 0, 0) and approaches by a rounding error: V⁻ = (1, −2⁻⁵³, 0). Up to this error, P_I =
/// 0 and D = P_II = (−5/8, 3/8, 0). D lies in the friction cone if μ ≥ 5/3.
Collision approached_by_rounding(double friction) {
  Collision c;
  c.a.principal_inertia.setConstant(1.0 / 6);
  c.a.position = {-0.5, 0.5, 0};
  c.a.velocity = {2, 1 - 0x1p-53, 0};
  c.a.angular_velocity = {0, 0, -2};
  c.b.immovable = true;
  c.friction = friction;
  return c;
}

Yardstick of_binary64() { return Yardstick::of(Precision::binary64); }

Accuracy accuracy_of(const ExactCase& exact_case, const Outcome<double>& outcome) {
  return accuracy(exact_case, Law::rough, LiftedOutcome(reported(outcome)), of_binary64());
}

TEST(Rough, HasTwoAnswersIfFrictionActsThoughTheApproachIsRounding) {
  const ExactCase exact_case(approached_by_rounding(2));
  ASSERT_EQ(exact_case.state(), ContactState::colliding);
  EXPECT_EQ(exact_case.branch(Law::rough), Branch::inside_cone);
  EXPECT_TRUE(exact_case.has_two_answers(Law::rough, of_binary64().allowance()));
  Outcome<double> between = exact_case.nearest_truth(Law::rough);
  EXPECT_TRUE(accuracy_of(exact_case, between).is_allowed());
  EXPECT_TRUE(accuracy_of(exact_case, unchanged(exact_case.collision())).is_allowed());
  between.a.velocity = (between.a.velocity + exact_case.collision().a.velocity) / 2;
  EXPECT_FALSE(accuracy_of(exact_case, between).is_allowed());
}

TEST(Rough, HasOneAnswerIfTheSlipVanishesWithTheApproach) {
  const ExactCase exact_case(approached_by_rounding(1));
  EXPECT_EQ(exact_case.branch(Law::rough), Branch::on_cone);
  EXPECT_FALSE(exact_case.has_two_answers(Law::rough, of_binary64().allowance()));
  EXPECT_TRUE(accuracy_of(exact_case, unchanged(exact_case.collision())).is_allowed());
  EXPECT_FALSE(accuracy_of(exact_case, ExactCase(approached_by_rounding(2)).nearest_truth(Law::rough)).is_allowed());
}

TEST(Rough, DecidesNothingIfItsTwoAnswersDifferByRounding) {
  const ExactCase exact_case(approached_by_rounding(5.0 / 3));
  EXPECT_TRUE(exact_case.is_open(Law::rough, of_binary64().allowance()));
  EXPECT_FALSE(accuracy_of(exact_case, unchanged(exact_case.collision())).is_decided);
}

/// At μ = 1/4, F lies exactly on the cone's surface. There, the sensitivity is the larger of the sensitivities inside
/// and outside.
TEST(Rough, IsAsSensitiveAtTheSurfaceAsOnEitherSide) {
  const auto sensitivity_at = [](double friction) {
    return ExactCase(rough_ball(friction)).sensitivity(Law::rough, of_binary64().allowance());
  };
  constexpr double beside = 0x1p-20;  // larger than rounding, and too small to change the sensitivities
  const Sensitivity inside = sensitivity_at(0.25 * (1 + beside));
  const Sensitivity on_cone = sensitivity_at(0.25 * (1 - beside));
  const Sensitivity at_surface = sensitivity_at(0.25);
  for (const OutcomeVector k : {OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a}) {
    const double expected = std::max(inside[k], on_cone[k]);
    EXPECT_NEAR(at_surface[k], expected, 16 * beside * expected) << name_of(k);
    EXPECT_GT(std::abs(inside[k] - on_cone[k]), 64 * beside * expected) << name_of(k);
  }
}

TEST(Rough, IsFrictionlessWithoutFriction) {
  const ExactCase exact_case(rough_ball(0));
  const double allowance = of_binary64().allowance();
  EXPECT_EQ(exact_case.branch(Law::rough), Branch::only);
  EXPECT_TRUE(same(exact_case.truth(Law::rough).impulse, exact_case.truth(Law::frictionless).impulse));
  EXPECT_EQ(exact_case.sensitivity(Law::rough, allowance), exact_case.sensitivity(Law::frictionless, allowance));
  Collision grazing = approached_by_rounding(2);
  grazing.friction = 0;
  EXPECT_FALSE(ExactCase(grazing).has_two_answers(Law::rough, allowance));
}

/// With κ = 1 + e_t, F = (3/2, 6, 0). So the distance |μ N·F − ‖N × F‖| = |6/8 − 3/2| = 3/4.
/// Only both signs together say that no share of friction reaches the cone.
TEST(Rough, IsUndecidedIfOneOfTwoSignsIsNotKnown) {
  const auto exact = map_numbers<Rational>(rough_ball(10), [](double x) { return Rational(x); });
  using Signs = std::vector<std::optional<int>>;
  for (const Signs& signs : {Signs{1, -1}, Signs{std::nullopt, -1}, Signs{1, std::nullopt}}) {
    auto next = signs.begin();
    const std::optional<bool> reaches =
        reaches_cone<Rational>(exact, nullptr, [&](const Rational&) { return *next++; });
    EXPECT_EQ(reaches.has_value(), signs[0].has_value() && signs[1].has_value());
  }
}

TEST(ConeDistance, IsHowFarTheImpulseIsFromTheSurface) {
  const Collision c = rough_ball(0.125);
  EXPECT_NEAR(cone_distance(c).distance, 0.75, 0x1p-47);
  EXPECT_NEAR(enclosed_cone_distance(c).distance, 0.75, 0x1p-47);
  EXPECT_TRUE(cone_distance(c).is_within(1));
  EXPECT_FALSE(cone_distance(c).is_within(0x1p-10));
}

/// The distance |μ N·F − ‖N × F‖|, exact up to one rounding.
double exact_distance(const Collision& collision) {
  const BasicCollision<Rational> c = lift(collision);
  const detail::RoughImpulses<Rational> of(c, nullptr);
  const Vector3<Rational> whole = Rough::combined<Rational>(c, of.stops_approach, of.difference(),
                                                            Rational(Rational(1) + c.tangential_restitution));
  const Sides<Rational, 1> cone = squared_cone(c, whole);
  const Radical limit = Radical(Rational(c.friction * c.normal.dot(whole)));
  return std::abs(to_double(Radical(limit - Radical::root_of(cone.left[0]))));
}

double band_by_forward_differentiation(const Collision& collision) {
  using T = unit::EnclosedDual;
  const auto inputs = unit::enclosed_inputs(collision);
  const BasicCollision<T>& c = inputs.collision;
  const detail::RoughImpulses<T> of(c, nullptr);
  const Vector3<T> whole =
      Rough::combined<T>(c, of.stops_approach, of.difference(), T(T(1) + c.tangential_restitution));
  const T limit = c.friction * c.normal.dot(whole);
  const Vector3<T> tangential = c.normal.cross(whole);
  return unit::sensitivity_by(&Enclosure::magnitude_above, {&limit}, inputs.quantities) +
         unit::sensitivity_by(&Enclosure::magnitude_above, {&tangential[0], &tangential[1], &tangential[2]},
                              inputs.quantities);
}

/// Implicit differentiation, in binary64 and in enclosures, agrees with forward differentiation of the whole law. A
/// sensitivity must be accurate to a thousandth.
TEST(ConeDistance, IsTheSameBothWays) {
  int compared = 0;
  for (const auto& [family, one] : unit::sampled_cases(20)) {
    const ExactCase exact_case(one.collision);
    if (exact_case.state() != ContactState::colliding || !exact_case.is_moderate() ||
        !exact_case.is_well_conditioned()) {
      continue;
    }
    const ConeDistance quick = cone_distance(one.collision);
    const ConeDistance enclosed = enclosed_cone_distance(one.collision);
    const double band = band_by_forward_differentiation(one.collision);
    EXPECT_NEAR(quick.sensitivity, band, 0x1p-10 * band) << family;
    EXPECT_NEAR(enclosed.sensitivity, band, 0x1p-10 * band) << family;
    const double exact = exact_distance(one.collision);
    for (const double distance : {quick.distance, enclosed.distance}) {
      EXPECT_LE(distance, exact) << family;
      // A lower bound is rounded down by 2⁻⁴⁸ of itself (enclosure.hpp). An enclosure has a relative error of 2⁻¹⁰⁰
      // times the condition number of K, which is below 2²⁰ here.
      EXPECT_GE(distance, (1 - 0x1p-47) * exact - 0x1p-80 * band) << family;
    }
    ++compared;
  }
  EXPECT_GT(compared, unit::effort(100));
}

TEST(ConeDistance, IsWithinAnyAllowanceIfItIsNotKnown) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE((ConeDistance{1, unknown}.is_within(0x1p-48)));
  EXPECT_TRUE((ConeDistance{unknown, 1}.is_within(0x1p-48)));
  EXPECT_FALSE((ConeDistance{1, 1}.is_within(0x1p-48)));
}

TEST(Radical, IsAFieldWithAnOrder) {
  const Radical root = Radical::root_of(Rational(2));
  const Radical x = Radical(3) - Radical(2) * root;  // 0.17…
  EXPECT_EQ(x * (Radical(3) + Radical(2) * root), 1);
  EXPECT_EQ(Radical(1) / x, Radical(3) + Radical(2) * root);
  EXPECT_GT(x, 0);
  EXPECT_LT(x, Radical(ratio(1, 5)));
  EXPECT_LT(-root, 0);
  EXPECT_EQ(root - root, 0);
  EXPECT_DOUBLE_EQ(to_double(x), 0.1715728752538099);
  EXPECT_EQ(to_text(x), "3 + -2 √(2)");
  Radical y = x;
  EXPECT_EQ(y += root, x + root);
  EXPECT_EQ(y -= root, x);
  EXPECT_EQ(y *= root, x * root);
  EXPECT_EQ(y /= root, x);
}

/// √2 minus its own approximation r is (2 − r²) / (√2 + r).
TEST(Radical, IsRoundedWithoutCancellation) {
  const Rational r = root_below(Rational(2)).root;
  const Radical difference = Radical::root_of(Rational(2)) - Radical(r);
  const double expected = to_double(Rational(2 - r * r)) / (2 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(to_double(difference), expected);
  EXPECT_DOUBLE_EQ(to_double(-difference), -expected);
  EXPECT_DOUBLE_EQ(to_double(Radical::root_of(Rational(2)) + Radical(r)), 2 * std::sqrt(2.0));
}

TEST(Radical, KnowsSquares) {
  EXPECT_TRUE(Radical::root_of(ratio(9, 4)).is_rational());
  EXPECT_EQ(Radical::root_of(ratio(9, 4)), Radical(ratio(3, 2)));
  EXPECT_EQ(Radical::root_of(Rational(0)), 0);
  EXPECT_EQ(Radical::root_of(Rational(0x1p-1000) * Rational(0x1p-1000)), Radical(Rational(0x1p-1000)));
}

TEST(Radical, RefusesDifferentRoots) {
  EXPECT_THROW((void)(Radical::root_of(Rational(2)) + Radical::root_of(Rational(3))), std::logic_error);
  EXPECT_THROW((void)(Radical::root_of(Rational(2)) * Radical::root_of(Rational(3))), std::logic_error);
}

TEST(Radical, BringsRootsToOne) {
  EXPECT_EQ(Radical::root_of(Rational(8)), Radical(2) * Radical::root_of(Rational(2)));
  EXPECT_EQ(Radical::root_of(Rational(8)) * Radical::root_of(Rational(2)), 4);
  EXPECT_EQ(Radical::root_of(ratio(1, 2)) / Radical::root_of(Rational(2)), Radical(ratio(1, 2)));
}

}  // namespace
}  // namespace carom::oracles
