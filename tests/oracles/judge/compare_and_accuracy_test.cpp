// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/judge/norm_at_most.hpp>
#include <carom/properties/cases/family.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;

Yardstick yardstick_of(Precision precision, bool filtered = true) {
  return Yardstick::of(precision, {.filtered = filtered});
}

Yardstick three_digits_of(Precision precision, bool filtered = true) {
  return Yardstick::of(precision, {.digits = 3, .filtered = filtered});
}

/// A falls on a fixed plane with (0, −1, 0) m/s. The lever arm is zero.
Collision falling_ball() {
  Collision c;
  c.a.velocity = {0, -1, 0};
  c.b.immovable = true;
  return c;
}

TEST(Compare, AllowsTheLimitTimesTheScale) {
  const ExactCase exact_case(falling_ball());
  const Yardstick yardstick = yardstick_of(Precision::binary64);
  // N = (0, 1, 0), V⁺ = (0, 1 + d, 0), V⁻ = (0, −1, 0) and ε = 1. The scale of g = N·V⁺ + ε N·V⁻ is a sum: d for N, 1
  // for ε, 1 for v_A⁻, and ‖v_A⁺‖ + ‖v_A⁻‖ = 2 + d for v_A⁺. The lever arm is zero, so w adds nothing. As d is
  // negligible, the scale is 4.
  const double allowed = yardstick.allowance() * 4;
  for (const double share : {0.0, 0.99, -0.99, 1.01, -1.01}) {
    const double deviation = share * allowed;
    const bool holds = std::abs(share) < 1;
    ReportedOutcome outcome;
    outcome.a.velocity = {0, 1 + static_cast<long double>(deviation), 0};
    const EquationCheck comparison =
        compare(equation::Restitution{}, EquationForm::equal, exact_case, LiftedOutcome(outcome), yardstick);
    EXPECT_EQ(comparison.holds, holds) << deviation;
    if (!holds) {
      EXPECT_NEAR(comparison.allowed, allowed, 0x1p-40 * allowed);
      EXPECT_NEAR(comparison.residual, std::abs(deviation), 0x1p-9 * allowed);  // 1 + deviation is rounded to extended
      EXPECT_EQ(comparison.right, std::vector<double>{1});
    }
  }
}

TEST(Compare, AllowsNothingInExactArithmetic) {
  const ExactCase exact_case(falling_ball());
  Outcome<Rational> outcome = exact_case.truth(Law::frictionless).outcome;
  const equation::Restitution restitution;
  EXPECT_TRUE(
      compare(restitution, EquationForm::equal, exact_case, LiftedOutcome(outcome), Yardstick::of_exact_arithmetic())
          .holds);
  outcome.a.velocity[1] += ratio(1, 1 << 30) * ratio(1, 1 << 30) * ratio(1, 1 << 30) * ratio(1, 1 << 30);
  EXPECT_FALSE(
      compare(restitution, EquationForm::equal, exact_case, LiftedOutcome(outcome), Yardstick::of_exact_arithmetic())
          .holds);
}

TEST(ExactCase, IsHeadOnOrCollinearOnlyIfNoComponentIsLeft) {
  for (const bool filtered : {true, false}) {
    for (int normal = 0; normal < 3; ++normal) {
      Collision c;
      c.normal = Vector3<double>::Unit(normal);
      c.point = -c.normal;
      c.a.velocity = -c.normal;
      c.b.immovable = true;
      EXPECT_TRUE(ExactCase(c, filtered).is_head_on()) << normal;
      EXPECT_TRUE(ExactCase(c, filtered).is_collinear()) << normal;
      for (int other = 1; other < 3; ++other) {
        Collision slips = c;
        slips.a.velocity[(normal + other) % 3] = 0x1p-60;
        EXPECT_FALSE(ExactCase(slips, filtered).is_head_on()) << normal << other;
        Collision off = c;
        off.point[(normal + other) % 3] = 0x1p-60;
        EXPECT_FALSE(ExactCase(off, filtered).is_collinear()) << normal << other;
      }
    }
  }
}

/// Condition (3) of docs/reference/yardstick.md#hard-cases: w, r and N are parallel.
TEST(PermittedInputs, AreUsedIfABodySpinsAboutTheNormal) {
  Collision c;
  c.normal = {0, 0, 1};
  c.point = {0, 0, 0.5};
  c.a.velocity = {0, 0, -1};
  c.b.immovable = true;
  // The sensitivity of N·V⁻ is ‖V⁻‖ + ‖v‖ = 2. The case is hard if ‖N‖ ‖w‖ ‖r‖ = ‖w‖ / 2 exceeds 32 times this
  // sensitivity.
  for (const double spin : {96.0, 160.0}) {
    c.a.angular_velocity = {0, 0, spin};
    EXPECT_EQ(ExactCase(c).permitted_inputs(0x1p-48) != nullptr, spin / 2 > 64) << spin;
  }
}

TEST(NormAtMost, IsExactAtTheBound) {
  EXPECT_TRUE(norm_at_most(std::vector<Rational>{3, 4}, 5));
  EXPECT_FALSE(norm_at_most(std::vector<Rational>{3, 4}, std::nextafter(5.0, 0)));
  EXPECT_TRUE(norm_at_most(std::vector<Rational>{}, 0));
  EXPECT_EQ(norm_at_most(std::vector<Enclosure>{3, 4}, 5.001), true);
  EXPECT_EQ(norm_at_most(std::vector<Enclosure>{3, 4}, 4.999), false);
  EXPECT_EQ(norm_at_most(std::vector<Enclosure>{3, 4}, 5), std::nullopt);
  EXPECT_EQ(norm_at_most(std::vector<Enclosure>{Enclosure(1 + 0.75 * norm_bounds::rounding)}, 1), std::nullopt);
  EXPECT_EQ(norm_at_most(std::vector<Enclosure>{Enclosure(1 + 2 * norm_bounds::rounding)}, 1), false);
}

/// The velocity changes by 2 m/s, so an outcome that is wrong by 2 · 10⁻³ m/s has a relative error of exactly 10⁻³, the
/// limit of three digits. The next larger velocity in extended precision exceeds the limit, although both relative
/// errors round to the same binary64 number.
TEST(Accuracy, HasDigitsUpToTheLastBit) {
  const ExactCase exact_case(falling_ball());
  Yardstick yardstick = three_digits_of(Precision::extended);
  EXPECT_DOUBLE_EQ(yardstick.allowance(), 1e-3);
  const auto bound = static_cast<long double>(yardstick.allowance());
  for (const bool filtered : {true, false}) {
    yardstick = yardstick.with_filters(filtered);
    for (const int ulps : {-1, 0, 1}) {
      ReportedOutcome outcome;
      outcome.a.velocity = {0, 1 + 2 * bound + static_cast<long double>(ulps) * 0x1p-63L, 0};
      const Accuracy result = accuracy(exact_case, Law::frictionless, LiftedOutcome(outcome), yardstick);
      EXPECT_EQ(result.has_digits, ulps <= 0) << filtered << ' ' << ulps;
    }
  }
}

/// A separates without spin, and 10⁻³ of no spin permits nothing. The noise is 32 ulps of 4 m/s at the radius √(least
/// moment / m) = 1/2 m.
TEST(Digits, PermitNoiseInProportionToTheLargestSpeed) {
  Collision c;
  c.a.velocity = {0, 4, 0};
  c.a.mass = 4;
  c.a.principal_inertia = {1, 2, 2};
  c.b.immovable = true;
  const ExactCase exact_case(c);
  Yardstick yardstick = yardstick_of(Precision::binary64);
  const double noise = default_limit_ulps * yardstick.unit_roundoff() * 4 / 0.5;
  const auto passes = [&](double spin) {
    ReportedOutcome outcome = reported(exact_case.nearest_truth(Law::frictionless));
    outcome.a.angular_velocity = {spin, 0, 0};
    return compare(equation::Untouched{OutcomeVector::angular_velocity_of_a}, EquationForm::equal, exact_case,
                   LiftedOutcome(outcome), yardstick)
        .holds;
  };
  EXPECT_FALSE(passes(0.9 * noise));
  yardstick = three_digits_of(Precision::binary64);
  EXPECT_TRUE(passes(0.9 * noise));
  EXPECT_FALSE(passes(1.1 * std::sqrt(3.0) * noise));  // an equation multiplies by the norm of the identity, √3
  EXPECT_EQ(permitted_noise(c, yardstick)[OutcomeVector::velocity_of_b], noise / 2);
  EXPECT_EQ(permitted_noise(c, yardstick)[OutcomeVector::angular_velocity_of_b], 0);
}

/// A known bound may replace the sensitivity by a lower bound of it, so the backward error grows, but not beyond the
/// known bound.
TEST(Accuracy, UsesTheSensitivityIfNoBoundIsKnown) {
  Yardstick yardstick = yardstick_of(Precision::binary64);
  Yardstick exactly = yardstick;
  exactly = exactly.with_filters(false);
  int larger = 0;
  for (const auto& [family, one] : unit::sampled_cases(1)) {
    const ExactCase exact_case(one.collision);
    const LiftedOutcome outcome(reported(exact_case.nearest_truth(Law::reflection)));
    const auto error_by = [&](const Yardstick& by, double known) {
      return accuracy(exact_case, Law::reflection, outcome, by, known).backward_error(by.unit_roundoff());
    };
    if (!accuracy(exact_case, Law::reflection, outcome, exactly).is_decided) {
      continue;
    }
    const double exact = error_by(exactly, 0);
    const double filtered = error_by(yardstick, 0);
    // Each component of the error is known to 2⁻¹⁰ of itself or of the permitted error, so the norm is known to √3
    // 2⁻¹⁰.
    EXPECT_NEAR(filtered, exact, 0x1p-9 * (exact + default_limit_ulps)) << family;
    constexpr double known = 1;
    const double bounded = error_by(yardstick, known);
    EXPECT_GE(bounded, filtered) << family;
    EXPECT_LE(bounded, std::max(known, filtered)) << family;
    larger += static_cast<int>(bounded > filtered);
  }
  EXPECT_GT(larger, 0);
}

TEST(Accuracy, CountsUlpsAndDigits) {
  // The velocity changes by 2 m/s, and the outcome has an error of 2⁻²⁰ m/s.
  const ExactCase exact_case(falling_ball());
  ReportedOutcome outcome;
  outcome.a.velocity = {0, 1 + 0x1p-20L, 0};
  Yardstick yardstick = yardstick_of(Precision::binary32);
  const Accuracy result = accuracy(exact_case, Law::frictionless, LiftedOutcome(outcome), yardstick);
  EXPECT_EQ(result.error[OutcomeVector::velocity_of_a], 0x1p-20);
  EXPECT_EQ(result.relative_error, 0x1p-21);
  EXPECT_NEAR(result.digits(), 21 * std::log10(2.0), 1e-12);  // 21 log10 2 = 6.3, to a few roundings
  EXPECT_EQ(result.backward_error(0x1p-24), 0x1p-20 / (0x1p-24 * result.sensitivity[OutcomeVector::velocity_of_a]));
  outcome.a.velocity = {0, 1, 0};
  const Accuracy exact = accuracy(exact_case, Law::frictionless, LiftedOutcome(outcome), yardstick);
  EXPECT_EQ(exact.backward_error(0x1p-24), 0);
  EXPECT_EQ(exact.digits(), 40);
}

/// The velocity changes by 2⁻⁹ m/s, and the outcome has an error of 2⁻²⁰ m/s.
TEST(Accuracy, CountsDigitsOfASmallChange) {
  Collision slow = falling_ball();
  slow.a.velocity *= 0x1p-10;
  ReportedOutcome outcome;
  outcome.a.velocity = {0, 0x1p-10L + 0x1p-20L, 0};
  const Accuracy result =
      accuracy(ExactCase(slow), Law::frictionless, LiftedOutcome(outcome), yardstick_of(Precision::binary32));
  EXPECT_EQ(result.relative_error, 0x1p-11);
}

/// The contact grazes and has two answers, and the outcome lies between them. The judge chooses the nearer answer. The
/// choice must not depend on the errors known before, and so not on the order of judgements.
TEST(Accuracy, IsOfTheNearerAnswerInAnyOrderOfQuestions) {
  const properties::Family& family = *properties::family_named("structured");
  const ExactCase exact_case(drawn_case(family, 1, 143).collision);
  const Yardstick yardstick = yardstick_of(Precision::binary64);
  ASSERT_TRUE(exact_case.has_two_answers(Law::sticking, yardstick.allowance()));
  const auto answer = [&](ContactState approach) {
    return map_outcome<long double>(exact_case.enclosed_truth(Law::sticking, approach).outcome,
                                    [](const Enclosure& x) { return static_cast<long double>(x.middle()); });
  };
  const Outcome<long double> colliding = answer(ContactState::colliding);
  const Outcome<long double> untouched = answer(ContactState::separating);
  for (const long double share : {0.25L, 0.4L, 0.5L, 0.6L, 0.75L}) {
    Outcome<long double> between = colliding;
    for (const OutcomeVector k : all_outcome_vectors) {
      *vectors(between)[k] += share * (*vectors(untouched)[k] - *vectors(colliding)[k]);
    }
    const auto is_of_truth = [&](double known) {
      return accuracy(exact_case, Law::sticking, LiftedOutcome(between), yardstick, known).is_of_truth;
    };
    EXPECT_EQ(is_of_truth(0), is_of_truth(HUGE_VAL)) << static_cast<double>(share);
  }
}

/// Errors just below and just above the permitted error, limit_ulps · unit_roundoff · sensitivity.
TEST(Accuracy, PassesUpToTheLimitOfTheYardstick) {
  for (const double speed : {1.0, 0x1p200}) {
    Collision c;
    c.a.velocity = {0, -speed, 0};
    c.b.immovable = true;
    const ExactCase exact_case(c);
    ASSERT_EQ(exact_case.is_moderate(), speed == 1);
    for (const bool filtered : {false, true}) {
      const Yardstick yardstick = Yardstick::of(Precision::binary64, {8, {}, filtered});
      const double allowed = 0x1p-50 * exact_case.sensitivity(Law::reflection, 0x1p-50)[OutcomeVector::velocity_of_a];
      for (const double part : {-0.999, 0.999, -1.001, 1.001}) {
        ReportedOutcome outcome;
        outcome.a.velocity = {0, speed + static_cast<long double>(part * allowed), 0};
        const Accuracy result = accuracy(exact_case, Law::reflection, LiftedOutcome(outcome), yardstick);
        EXPECT_EQ(result.allowed[OutcomeVector::velocity_of_a], std::abs(part) < 1) << part;
      }
    }
  }
}

/// Let η be the least number of binary32. Underflow causes an error of η / 2 in a spin of any size.
TEST(Yardstick, AddsTheLossByUnderflow) {
  constexpr long double least = std::numeric_limits<float>::denorm_min();
  Collision c;
  c.a.position = {0, 1, 0};
  c.b.position = {0, -1, 0};
  ReportedOutcome outcome;
  outcome.a.velocity = {least, 0, 0};
  outcome.b.velocity = {-least, 0, 0};
  outcome.a.angular_velocity = {0, 0, 2 * least};  // from r × m Δv = (0, 0, η)
  for (const bool filtered : {false, true}) {
    Yardstick yardstick = yardstick_of(Precision::binary32, filtered);
    const auto holds = [&] {
      return compare(equation::AngularMomentum{true}, EquationForm::equal, ExactCase(c), LiftedOutcome(outcome),
                     yardstick)
          .holds;
    };
    EXPECT_TRUE(holds());
    outcome.a.angular_velocity[2] = 4000 * least;
    EXPECT_FALSE(holds());
    outcome.a.angular_velocity[2] = 2 * least;
    // The same allowance in binary64, whose least number is negligible here.
    yardstick = Yardstick::of(Precision::binary64, {default_limit_ulps * 0x1p29, {}, filtered});
    EXPECT_FALSE(holds());
  }
}

/// The allowance times a finite scale overflows, so neither the filtered nor the exact judge decides.
TEST(Range, AnAllowanceThatOverflowsDecidesNothing) {
  Collision c;
  c.a.mass = 0x1p500;
  c.b.mass = 0x1p500;
  c.a.velocity = {0, -0x1p495, 0};
  ReportedOutcome outcome;
  outcome.a.velocity = {0, 0x1p490L, 0};
  for (const bool filtered : {true, false}) {
    for (const double limit_ulps : {default_limit_ulps, 1e16}) {
      const Yardstick yardstick = Yardstick::of(Precision::binary32, {limit_ulps, {}, filtered});
      const EquationCheck momentum =
          compare(equation::LinearMomentum{}, EquationForm::equal, ExactCase(c), LiftedOutcome(outcome), yardstick);
      EXPECT_EQ(momentum.is_decided, limit_ulps == default_limit_ulps) << "the scale itself is in range";
      EXPECT_FALSE(momentum.is_decided && momentum.holds);
    }
  }
}

/// If the allowance times the scale underflows, the product loses digits or is zero.
TEST(Range, AnAllowanceThatUnderflowsDecidesNothing) {
  Yardstick yardstick = yardstick_of(Precision::binary64);
  EXPECT_EQ(yardstick.allowed(0), 0);
  EXPECT_EQ(yardstick.allowed(1), 0x1p-48);
  EXPECT_TRUE(yardstick.allowed(0x1p-974).has_value());
  for (const double scale : {0x1p-975, 0x1p-1022, 0x1p-1074}) {
    EXPECT_FALSE(yardstick.allowed(scale).has_value()) << scale;
  }
  for (const double scale : {HUGE_VAL, std::nan("")}) {
    EXPECT_FALSE(yardstick.allowed(scale).has_value()) << scale;
    EXPECT_FALSE(Yardstick::of_exact_arithmetic().allowed(scale).has_value()) << "nor where nothing is allowed";
  }
  EXPECT_EQ(Yardstick::of_exact_arithmetic().allowed(0x1p-1074), 0);
}

/// A ball slides along a wall, and the rounding of the inputs exceeds its approach. If the ball collides, `sticking`
/// stops its slip. Otherwise the slip stays. Both outcomes pass, but no outcome between them passes.
TEST(Accuracy, TakesEitherOfTwoAnswers) {
  Yardstick yardstick = yardstick_of(Precision::binary64);
  for (const double approach : {-0x1p-60, 0x1p-60}) {
    Collision c;
    c.normal = {0x1p-10, 1, 0};
    c.a.velocity = {1, -0x1p-10 + approach, 0};
    c.b.immovable = true;
    const ExactCase exact_case(c);
    ASSERT_EQ(exact_case.state(), approach < 0 ? ContactState::colliding : ContactState::separating);
    ASSERT_TRUE(exact_case.has_two_answers(Law::sticking, yardstick.allowance()));
    EXPECT_FALSE(exact_case.has_two_answers(Law::reflection, yardstick.allowance()));
    for (const bool filtered : {false, true}) {
      yardstick = yardstick.with_filters(filtered);
      const auto result_for = [&](const Outcome<double>& outcome) {
        const auto reported = carom::reported(outcome);
        return accuracy(exact_case, Law::sticking, LiftedOutcome(reported), yardstick);
      };
      Outcome<double> stopped = unchanged(c);
      stopped.a.velocity.setZero();
      Outcome<double> between = unchanged(c);
      between.a.velocity *= 0.5;
      EXPECT_TRUE(result_for(unchanged(c)).is_allowed());
      EXPECT_EQ(result_for(unchanged(c)).is_of_truth, approach > 0);
      EXPECT_TRUE(result_for(stopped).is_allowed());
      EXPECT_EQ(result_for(stopped).is_of_truth, approach < 0);
      EXPECT_FALSE(result_for(between).is_allowed());
    }
  }
}

/// The judge compares an outcome with the nearer of two answers, even if both permit the outcome.
TEST(Accuracy, IsThatOfTheNearerAnswer) {
  Yardstick yardstick = yardstick_of(Precision::binary64);
  Collision c;
  c.normal = {0x1p-10, 1, 0};
  c.b.velocity = {1, -0x1p-10, 0};
  c.a.velocity = {1 + 0x1p-51, -0x1p-10 - 0x3p-62, 0};  // N·V⁻ = −2⁻⁶²
  const ExactCase exact_case(c);
  ASSERT_EQ(exact_case.state(), ContactState::colliding);
  ASSERT_TRUE(exact_case.has_two_answers(Law::sticking, yardstick.allowance()));
  const auto unmoved = reported(unchanged(c));
  EXPECT_EQ(
      accuracy(exact_case, Law::sticking, LiftedOutcome(unmoved), yardstick).backward_error(yardstick.unit_roundoff()),
      0);
}

/// A body has the velocity of a moving wall, so the first derivatives of the energy vanish. The rounding of the
/// velocity exceeds the change of the velocity by the impulse.
TEST(Compare, AllowsEnergyTheRoundingOfVelocities) {
  Yardstick yardstick = yardstick_of(Precision::binary32);
  Collision c;
  c.b.immovable = true;
  c.a.velocity = c.b.velocity = {0x1p+25, -0x1p+27, 0};
  c.a.position = {0, 0, 1};
  c.normal = {1, 0, 0};
  c.b.angular_velocity = {0, -0x1p-11, 0};
  c.b.position = {0, 0, 0x1p-14};
  Outcome<long double> after = reported(unchanged(c));
  const auto holds = [&] {
    return compare(equation::Energy{}, EquationForm::at_most, ExactCase(c), LiftedOutcome(after), yardstick).holds;
  };
  after.a.angular_velocity[1] = 0x1p-27;
  EXPECT_TRUE(holds());
  after.a.angular_velocity[1] = 0x1p+10;
  EXPECT_FALSE(holds());
}

/// A ball keeps its velocity of length 5 and gains the velocity d across the normal. So F = m (d, 0, 0) and N·F = 0.
/// With n = ‖N‖, the residual is ‖N × F‖² = (n m d)². Let α be the allowance. The permitted residual is (n m)² α times
/// a sum: 10 d for v⁻, 20 d for v⁺, 4 d² (negligible) for m and N, and 100 α (1 + μ²) for the square of the uncertainty
/// of F. With μ = 7, the outcome passes if d² ≤ α (30 d + 5000 α), that is, if d ≤ 87.3 α.
TEST(Compare, AllowsTheFrictionConeTheRoundingOfTheImpulse) {
  Yardstick yardstick = yardstick_of(Precision::binary64);
  const double allowance = yardstick.allowance();
  for (const bool of_a : {true, false}) {
    Collision c;
    Body& ball = of_a ? c.a : c.b;
    (of_a ? c.b : c.a).immovable = true;
    ball.mass = 0x1p+10;
    ball.velocity = {0, of_a ? -5.0 : 5.0, 0};
    c.normal = {0, 0x1p+5, 0};
    c.friction = 7;
    for (const double times : {85.0, 90.0}) {
      ReportedOutcome outcome = reported(unchanged(c));
      (of_a ? outcome.a : outcome.b).velocity[0] = times * allowance;
      for (const bool filtered : {false, true}) {
        yardstick = yardstick.with_filters(filtered);
        const EquationCheck result = compare(equation::FrictionCone{of_a}, EquationForm::at_most, ExactCase(c),
                                             LiftedOutcome(outcome), yardstick);
        EXPECT_EQ(result.holds, times < 87.3) << of_a << ' ' << times;
      }
    }
  }
}

/// A ball moves with a wall, but for the velocities d and e of the rounding's size. F = m (d, 0, 0), V⁺ = (d, 0, −e),
/// and the residual is n² m d e with n = ‖N‖. Let α be the allowance. The permitted residual is n² m α times a sum: 5
/// √(d² + e²) for v⁻, 10 e + 10 d for the velocities after the impulse, and 200 α for the product of the uncertainties
/// of F (10 m α) and of V⁺ (20 α). With d = e, the outcome passes if d² ≤ α (27.1 d + 200 α), that is, if d ≤ 33.1 α.
TEST(Compare, AllowsFrictionAcrossTheSlipTheRoundingOfBoth) {
  const Yardstick yardstick = yardstick_of(Precision::binary64);
  for (const bool of_a : {true, false}) {
    Collision c;
    Body& ball = of_a ? c.a : c.b;
    Body& wall = of_a ? c.b : c.a;
    wall.immovable = true;
    ball.mass = 0x1p+4;
    ball.velocity = wall.velocity = {0, -5, 0};
    c.normal = {0, 0x1p+5, 0};
    for (const double times : {32.0, 34.0}) {
      wall.velocity[2] = times * yardstick.allowance();
      ReportedOutcome outcome = reported(unchanged(c));
      (of_a ? outcome.a : outcome.b).velocity[0] = times * yardstick.allowance();
      EXPECT_EQ(compare(equation::FrictionAlongSlip{of_a}, EquationForm::equal, ExactCase(c), LiftedOutcome(outcome),
                        yardstick)
                    .holds,
                times < 33.1)
          << of_a << ' ' << times;
    }
  }
}

/// The lever arm is 0, and the ball keeps its velocity, so no slope allows it the spin δ. The residual is J δ = 2 δ.
/// Let α be the allowance. The lever arm has the uncertainty (5 + 5 + 1/2) α, with the extent √(J / (2 m)) = 1/2, and m
/// Δv has the uncertainty 4 (2 + 2) α. So δ ≤ 84 α² passes.
TEST(Compare, AllowsAngularMomentumTheRoundingOfArmAndVelocity) {
  const Yardstick yardstick = yardstick_of(Precision::binary64);
  for (const bool of_a : {true, false}) {
    Collision c;
    Body& ball = of_a ? c.a : c.b;
    (of_a ? c.b : c.a).immovable = true;
    ball.mass = 4;
    ball.principal_inertia.setConstant(2);
    ball.position = c.point = {3, 4, 0};
    ball.velocity = {0, -2, 0};
    for (const double times : {83.0, 85.0}) {
      ReportedOutcome outcome = reported(unchanged(c));
      (of_a ? outcome.a : outcome.b).angular_velocity[0] = times * yardstick.allowance() * yardstick.allowance();
      EXPECT_EQ(
          compare(equation::AngularMomentum{of_a}, EquationForm::equal, ExactCase(c), LiftedOutcome(outcome), yardstick)
              .holds,
          times < 84)
          << of_a << ' ' << times;
    }
  }
}

/// F = (d, 0, 2), where d is less than a binary64 ulp of the velocity. The allowance is α = d / 16. μ is so chosen that
/// μ N·F = d − t α, with t = `times`. The residual is ‖N × F‖² − (μ N·F)² = d² − (d − t α)² = (2 t − t² / 16) d α. The
/// permitted residual is 12.5 d α: 8.1 d α for the velocities (2 ‖v⁺‖ + 4 ‖v⁻‖), 4 d α for N, and 7.3 α² for the square
/// of the uncertainty of F. So t ≤ 8.5 passes.
TEST(Compare, AllowsTheFrictionConeAllDigitsOfExtended) {
  Yardstick yardstick = yardstick_of(Precision::extended);
  constexpr double d = 0x1p-55;
  for (const double times : {7.5, 9.5}) {
    Collision c;
    c.b.immovable = true;
    c.a.velocity = {0.75, 0.5, -1};
    c.normal = {0, 0, 1};
    c.friction = (d - times * yardstick.allowance()) / 2;
    ReportedOutcome outcome = reported(unchanged(c));
    outcome.a.velocity += Vector3<long double>(d, 0, 2);
    for (const bool filtered : {false, true}) {
      yardstick = yardstick.with_filters(filtered);
      const EquationCheck result =
          compare(equation::FrictionCone{true}, EquationForm::at_most, ExactCase(c), LiftedOutcome(outcome), yardstick);
      EXPECT_EQ(result.holds, times < 8.5) << times << ' ' << result.residual << ' ' << result.allowed;
    }
  }
}

/// The energies leave the range of binary64. If the unit roundoff is 0, the permitted residual is 0 and needs no scale.
TEST(Range, AScaleBeyondBinary64DecidesOnlyExactArithmetic) {
  Collision c;
  c.b.immovable = true;
  c.a.mass = 0x1p+1000;
  c.a.velocity = {0, -0x1p+30, 0};
  ReportedOutcome outcome = reported(unchanged(c));
  outcome.a.velocity *= -2;
  for (const bool filtered : {true, false}) {
    for (Yardstick yardstick : {Yardstick::of_exact_arithmetic(), yardstick_of(Precision::binary64)}) {
      yardstick = yardstick.with_filters(filtered);
      const EquationCheck result =
          compare(equation::Energy{}, EquationForm::at_most, ExactCase(c), LiftedOutcome(outcome), yardstick);
      EXPECT_EQ(result.is_decided, yardstick.unit_roundoff() == 0);
      EXPECT_FALSE(result.is_decided && result.holds);
    }
  }
}

/// The impulse overflows.
TEST(Compare, OfAMatrixIsUndecidedBeyondTheRangeOfNumbers) {
  Collision c;
  c.b.immovable = true;
  c.a.mass = 0x1p+1000;
  c.a.velocity = {0, -0x1p+100, 0};
  ReportedOutcome outcome = reported(unchanged(c));
  outcome.a.velocity *= -1;
  Yardstick yardstick = yardstick_of(Precision::binary64);
  const LiftedMatrix shown(Matrix3<long double>(Matrix3<long double>::Identity()));
  EXPECT_FALSE(compare_change_by(shown, ExactCase(c), LiftedOutcome(outcome), yardstick).is_decided);
}

/// Without spin, no product of a spin and a lever arm can hide the approach, however slow it is.
TEST(PermittedInputs, AreNotNeededForASlowContactWithoutSpin) {
  Collision c;
  c.a.position = {0.25, 1, 0.5};
  c.b.position = {-0.5, -1, 0.25};
  c.a.velocity = {0x1p-20, -0x1p-20, 0};
  EXPECT_EQ(ExactCase(c).permitted_inputs(0x1p-40), nullptr);
  c.a.angular_velocity = {0.5, 0, 0};
  EXPECT_EQ(ExactCase(c).permitted_inputs(0x1p-40), nullptr) << "the spin adds to the approach";
  c.a.angular_velocity = {0, 0x1p+10, 0};
  c.a.position = {0, 1, 0};
  EXPECT_NE(ExactCase(c).permitted_inputs(0x1p-40), nullptr) << "the spin is about the lever arm";
}

TEST(Accuracy, IsInfiniteForAnImpulseWhereNoneIsDue) {
  Collision c;
  c.a.velocity = {0, 1, 0};
  c.b.immovable = true;
  ReportedOutcome outcome;
  outcome.a.velocity = {0, 2, 0};
  Yardstick yardstick = yardstick_of(Precision::binary64);
  const Accuracy result = accuracy(ExactCase(c), Law::reflection, LiftedOutcome(outcome), yardstick);
  EXPECT_EQ(result.allowed, (PerVector<bool>{false, true, true, true}));
  EXPECT_TRUE(std::isinf(result.relative_error));
}

}  // namespace
}  // namespace carom::oracles
