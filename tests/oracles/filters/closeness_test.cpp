// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/filters/closeness.hpp>
#include <carom/oracles/filters/slopes.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/models/models.hpp>
#include <carom/oracles/numbers/components.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

/// Calls visit(relation, equation) for every affine equation that applies to this collision, if the law's truth
/// satisfies the equation.
template <class Visit>
void for_each_affine_equation(const ExactCase& exact_case, Law law, const Visit& visit) {
  const Collision& c = exact_case.collision();
  const bool collides = exact_case.approach() == Approach::colliding;
  const bool inert = exact_case.approach() == Approach::inert;
  for (const bool a : {true, false}) {
    const bool immovable = a ? c.a.immovable : c.b.immovable;
    if (immovable || !collides) {
      visit(Relation::equal, equation::Untouched{a ? OutcomeVector::velocity_of_a : OutcomeVector::velocity_of_b});
      visit(Relation::equal,
            equation::Untouched{a ? OutcomeVector::angular_velocity_of_a : OutcomeVector::angular_velocity_of_b});
    }
    if (!immovable) {
      visit(Relation::equal, equation::AngularMomentum{a});
    }
  }
  if (!c.a.immovable && !c.b.immovable) {
    visit(Relation::equal, equation::LinearMomentum{});
    visit(Relation::equal, equation::TotalAngularMomentum{});
  }
  if (collides) {
    visit(Relation::equal, equation::Restitution{});
  }
  if (inert) {
    return;
  }
  const bool off_a = reads_impulse_off_a(exact_case.collision());
  visit(Relation::at_least, equation::NonPenetration{});
  const auto visit_if_kept = [&](Relation relation, const auto& equation) {
    if (keeps(law, *equation.name())) {
      visit(relation, equation);
    }
  };
  visit_if_kept(Relation::at_least, equation::Push{off_a});
  visit_if_kept(Relation::equal, equation::FrictionlessDirection{off_a});
  visit_if_kept(Relation::equal, equation::ReflectionPlane{});
  if (collides) {
    visit_if_kept(Relation::equal, equation::Sticks{});
  }
}

template <int N>
std::vector<Rational> residual(const Sides<Rational, N>& sides) {
  const auto all = difference(sides.left, sides.right);
  return {all.begin(), all.end()};
}

Outcome<Rational> plus(const Outcome<Rational>& x, const Outcome<Rational>& y, int times) {
  Outcome<Rational> result = x;
  for (const OutcomeVector k : all_outcome_vectors) {
    *vectors(result)[k] += *vectors(y)[k] * Rational(times);
  }
  return result;
}

Outcome<Rational> small_outcome(properties::Stream& stream) {
  return {{unit::exact_eighths3(stream, 9), unit::exact_eighths3(stream, 9)},
          {unit::exact_eighths3(stream, 9), unit::exact_eighths3(stream, 9)}};
}

/// Closeness assumes that equations are affine, g(y + d) + g(y − d) = 2 g(y), and that the truth y satisfies them
/// exactly.
TEST(Closeness, RestsOnLawsThatAreAffineAndSatisfiedByTheTruth) {
  properties::Stream stream = properties::stream_from(41);
  for (const auto& [family, one] : unit::sampled_cases(4)) {
    const ExactCase exact_case(one.collision);
    for (const Law law : linear_laws) {
      const Outcome<Rational>& y = exact_case.truth(law).outcome;
      const Outcome<Rational> d = small_outcome(stream);
      for_each_affine_equation(exact_case, law, [&, family = family](Relation relation, const auto& equation) {
        const int name = static_cast<int>(*equation.name());
        const auto at_truth = residual(equation(exact_case.exact(), y));
        const auto above = residual(equation(exact_case.exact(), plus(y, d, 1)));
        const auto below = residual(equation(exact_case.exact(), plus(y, d, -1)));
        for (std::size_t i = 0; i < at_truth.size(); ++i) {
          EXPECT_EQ(above[i] + below[i], 2 * at_truth[i]) << family << ' ' << name;
          EXPECT_TRUE(relation == Relation::equal ? at_truth[i] == 0 : at_truth[i] >= 0) << family << ' ' << name;
        }
      });
    }
  }
}

/// Let g = E⁺ − E⁻ − W, with the kinetic energies E⁺ after and E⁻ before the impulse, and the work W of a moving wall.
/// g is convex: g(y + d) + g(y − d) ≥ 2 g(y). At the truth y of the frictionless law, g ≤ 0.
TEST(Closeness, RestsOnAnEnergyThatIsConvex) {
  properties::Stream stream = properties::stream_from(42);
  const auto gain = [](const ExactCase& exact_case, const Outcome<Rational>& y) {
    return residual(equation::Energy{}(exact_case.exact(), y)).front();
  };
  for (const auto& [family, one] : unit::sampled_cases(6)) {
    const ExactCase exact_case(one.collision);
    if (exact_case.approach() == Approach::inert) {
      continue;
    }
    const Outcome<Rational>& y = exact_case.truth(Law::frictionless).outcome;
    const Outcome<Rational> d = small_outcome(stream);
    EXPECT_GE(gain(exact_case, plus(y, d, 1)) + gain(exact_case, plus(y, d, -1)), 2 * gain(exact_case, y)) << family;
    EXPECT_LE(gain(exact_case, y), 0) << family;
  }
}

/// ‖∂g/∂ŷ_k‖ of an affine equation g, by exact differences g(y + e) − g(y) for unit vectors e.
template <class OneEquation>
PerVector<double> exact_slopes(const OneEquation& equation, const ExactCase& exact_case) {
  const Outcome<Rational> before = unchanged(exact_case.exact());
  const auto at_rest = residual(equation(exact_case.exact(), before));
  PerVector<double> slopes{};
  for (const OutcomeVector k : all_outcome_vectors) {
    Rational squared(0);
    for (int axis = 0; axis < 3; ++axis) {
      Outcome<Rational> moved = before;
      (*vectors(moved)[k])[axis] += 1;
      const auto there = residual(equation(exact_case.exact(), moved));
      for (std::size_t i = 0; i < there.size(); ++i) {
        squared += (there[i] - at_rest[i]) * (there[i] - at_rest[i]);
      }
    }
    slopes[k] = std::sqrt(to_double(squared));
  }
  return slopes;
}

/// Computed and exact slopes (norms of derivatives) agree to 2⁻⁴⁰, except for slopes that contain r × N, which may
/// cancel.
TEST(Closeness, RestsOnSlopesThatAreKnownToTwelveDigits) {
  int moderate = 0;
  for (const auto& [family, one] : unit::sampled_cases(6)) {
    const Collision& c = one.collision;
    const ExactCase exact_case(c);
    if (!exact_case.bounds().is_moderate()) {
      continue;
    }
    ++moderate;
    for (const Law law : laws_with_truth) {
      for_each_affine_equation(exact_case, law, [&, family = family](Relation, const auto& equation) {
        const int name = static_cast<int>(*equation.name());
        const PerVector<double> computed = slopes_of(equation, c);
        const PerVector<double> exact = exact_slopes(equation, exact_case);
        for (const OutcomeVector k : all_outcome_vectors) {
          const bool of_a = k == OutcomeVector::velocity_of_a || k == OutcomeVector::angular_velocity_of_a;
          const bool of_spin = k == OutcomeVector::angular_velocity_of_a || k == OutcomeVector::angular_velocity_of_b;
          const bool may_cancel = of_spin && is_of_normal_velocity(*equation.name());
          const double arm = lever_arm(of_a ? c.a : c.b, c.point).norm();
          EXPECT_NEAR(computed[k], exact[k], may_cancel ? 0x1p-46 * arm * c.normal.norm() : 0x1p-40 * exact[k])
              << family << ' ' << name << ' ' << name_of(k);
        }
      });
    }
  }
  EXPECT_GT(moderate, 20);
}

struct Shown {
  int laws = 0;
  int shown = 0;
  int energies = 0;
};

/// Moves each vector of the rounded truth by up to `times` · allowance · its length. If Closeness shows that the result
/// satisfies an equation, the exact judge must agree.
Shown expect_shown_to_hold(double times, double least_shown, properties::Stream& stream) {
  Shown counts;
  Yardstick yardstick;
  yardstick.unit_roundoff = unit_roundoff(Precision::binary64);
  Yardstick exactly = yardstick;
  exactly.filtered = false;
  for (const auto& [family, one] : unit::sampled_cases(8)) {
    const ExactCase exact_case(one.collision);
    for (const Law law : laws_with_truth) {
      ReportedOutcome reported =
          map_outcome<long double>(exact_case.nearest_truth(law), [](double x) { return static_cast<long double>(x); });
      for (Vector3<long double>* part : vectors(reported)) {
        const Vector3<double> step = stream.direction().normalized() * (stream.unit() * times * yardstick.allowance());
        *part += step.cast<long double>() * part->norm();
      }
      const LiftedOutcome outcome(reported);
      const Accuracy measured = accuracy(exact_case, law, outcome, yardstick);
      if (!exact_case.bounds().is_moderate() || !outcome.is_moderate() || !measured.is_decided) {
        continue;
      }
      const Closeness closeness(exact_case.bounds(), law, outcome, measured.error_above, yardstick.allowance());
      for_each_affine_equation(exact_case, law, [&, family = family](Relation relation, const auto& equation) {
        ++counts.laws;
        if (closeness.shows(equation)) {
          ++counts.shown;
          const Comparison comparison = compare(equation, relation, exact_case, outcome, exactly);
          EXPECT_TRUE(comparison.holds && comparison.is_decided) << family << ' ' << static_cast<int>(*equation.name());
        }
      });
      if (exact_case.approach() != Approach::inert && closeness.shows_energy()) {
        ++counts.energies;
        EXPECT_TRUE(compare(equation::Energy{}, Relation::at_most, exact_case, outcome, exactly).holds) << family;
      }
    }
  }
  EXPECT_GE(counts.shown, least_shown * counts.laws) << "of " << counts.laws;
  return counts;
}

TEST(Closeness, ShowsOnlyWhatHolds) {
  properties::Stream stream = properties::stream_from(43);
  EXPECT_GT(expect_shown_to_hold(0, 0.95, stream).energies, unit::effort(100));
  expect_shown_to_hold(1, 0.8, stream);
  const Shown beyond = expect_shown_to_hold(4, 0, stream);
  EXPECT_LT(beyond.shown, beyond.laws / 2);
}

/// The lever arms of two spinning spheres are along the normal. So r × N = 0, and the computed slopes of N·V⁺ are
/// rounding errors.
TEST(Closeness, LeavesANormalVelocityThatCancelsToOthers) {
  Collision c;
  c.normal = {0.1, 0.3, 0.7};
  c.point = {0, 0, 0};
  c.a.position = 3 * c.normal;
  c.b.position = -3 * c.normal;
  c.a.angular_velocity = {1, 2, 3};
  const ExactCase exact_case(c);
  const PerVector<double> error_above{0, 0x1p-60, 0, 0};
  const LiftedOutcome outcome(map_outcome<long double>(unchanged(c), [](double x) { return x; }));
  const Closeness closeness(exact_case.bounds(), Law::frictionless, outcome, error_above, 0x1p-48);
  EXPECT_TRUE(closeness.shows(equation::AngularMomentum{true}));
  EXPECT_FALSE(closeness.shows(equation::NonPenetration{}));
}

/// N·V⁺ is a difference of spins alone. Its slope must be at least 2⁻²⁵ times the lengths that cancel in it.
TEST(Closeness, KnowsANormalVelocityByTheSpinOfEitherBody) {
  for (Body Collision::*spinning : {&Collision::a, &Collision::b}) {
    for (const double sine : {1.1 * 0x1p-25, 0.9 * 0x1p-25}) {
      Collision c;
      c.normal = {0, 0, 2};
      (c.*spinning).position = {-3 * sine, 0, -3};
      (c.*spinning).angular_velocity = {0, 5, 0};
      const ExactCase exact_case(c);
      const LiftedOutcome outcome(reported(unchanged(c)));
      const Closeness closeness(exact_case.bounds(), Law::frictionless, outcome, PerVector<double>{}, 0x1p-48);
      EXPECT_EQ(closeness.shows(equation::NonPenetration{}), sine > 0x1p-25) << sine;
    }
  }
}

/// Whether closeness shows the equation of energy, for an outcome whose vector k of body A is (`along_x`, 0, 0).
bool shows_energy(const Collision& c, OutcomeVector k, double along_x) {
  const ExactCase exact_case(c);
  PerVector<double> error_above{};
  error_above[k] = 0x1p-60;
  Outcome<double> after = unchanged(c);
  *vectors(after)[k] = {along_x, 0, 0};
  const LiftedOutcome outcome(map_outcome<long double>(after, [](double x) { return x; }));
  return Closeness(exact_case.bounds(), Law::frictionless, outcome, error_above, 0x1p-48).shows_energy();
}

/// The impulse nearly stops body A, or leaves it with the velocity of a wall. Closeness decides only if the slope of
/// the energy is at least 2⁻¹⁹ times the sum of the lengths that cancel in this slope.
TEST(Closeness, LeavesAnEnergyWhoseSlopeCancelsToOthers) {
  for (const double unit : {1.0, 0x1p+6, 0x1p-6}) {
    Collision c;
    c.a.mass = unit;
    c.a.principal_inertia.setConstant(unit);
    Collision spins = c;
    spins.a.angular_velocity = {0x1p+10, 0, 0};
    EXPECT_TRUE(shows_energy(spins, OutcomeVector::angular_velocity_of_a, 1.1 * 0x1p-9)) << unit;
    EXPECT_FALSE(shows_energy(spins, OutcomeVector::angular_velocity_of_a, 0.9 * 0x1p-9)) << unit;
    Collision slides = c;
    slides.a.velocity = {0x1p+10, 0, 0};
    EXPECT_TRUE(shows_energy(slides, OutcomeVector::velocity_of_a, 1.1 * 0x1p-9)) << unit;
    EXPECT_FALSE(shows_energy(slides, OutcomeVector::velocity_of_a, 0.9 * 0x1p-9)) << unit;
    // The lengths are 2¹⁰ for A before and after, 2¹⁰ for the velocity of the wall, and 2⁹ · 2 for the spin of the wall
    // times its lever arm.
    slides.b.immovable = true;
    slides.b.velocity = {0x1p+10, 0, 0};
    slides.b.position = {0, -2, 0};
    slides.b.angular_velocity = {0, 0x1p+9, 0};
    EXPECT_TRUE(shows_energy(slides, OutcomeVector::velocity_of_a, 0x1p+10 + 1.1 * 0x1p-7)) << unit;
    EXPECT_FALSE(shows_energy(slides, OutcomeVector::velocity_of_a, 0x1p+10 + 0.9 * 0x1p-7)) << unit;
  }
}

/// An outcome without error is the truth, so its energy needs no slope.
TEST(Closeness, ShowsTheEnergyOfAnOutcomeWithoutErrorWhoseSlopeCancels) {
  Collision c;
  c.a.velocity = {0x1p+10, 0, 0};
  const ExactCase exact_case(c);
  const LiftedOutcome at_rest(ReportedOutcome{});
  for (const double error : {0.0, 0x1p-60}) {
    const Closeness closeness(exact_case.bounds(), Law::frictionless, at_rest, {error, 0, 0, 0}, 0x1p-48);
    EXPECT_EQ(closeness.shows_energy(), error == 0) << error;
  }
}

TEST(Closeness, ShowsNothingThatTheTruthDoesNotSatisfy) {
  const ExactCase exact_case(unit::case_of("elastic", 0).collision);
  const PerVector<double> no_error{};
  const LiftedOutcome outcome(map_outcome<long double>(unchanged(exact_case.collision()), [](double x) { return x; }));
  const Closeness frictionless(exact_case.bounds(), Law::frictionless, outcome, no_error, 0x1p-48);
  const Closeness reflection(exact_case.bounds(), Law::reflection, outcome, no_error, 0x1p-48);
  const equation::FrictionlessDirection direction{true};
  EXPECT_TRUE(frictionless.shows(direction));
  EXPECT_FALSE(reflection.shows(direction));
  EXPECT_FALSE(frictionless.shows(equation::ReflectionPlane{}));
  EXPECT_TRUE(reflection.shows(equation::ReflectionPlane{}));
  EXPECT_TRUE(frictionless.shows_energy());
  EXPECT_FALSE(reflection.shows_energy());
}

/// The errors are relative to the lengths of the vectors before the impulse.
TEST(Closeness, ShowsVectorsUntouchedUpToTheAllowance) {
  const ExactCase exact_case(unit::case_of("separating", 0).collision);
  const Collision& c = exact_case.collision();
  const LiftedOutcome outcome(reported(unchanged(c)));
  constexpr double allowance = 0x1p-48;
  for (const double times : {0.99, 1.01}) {
    PerVector<double> errors = exact_case.bounds().norms_before();
    for (double& error : errors) {
      error *= times * allowance;
    }
    const Closeness closeness(exact_case.bounds(), Law::reflection, outcome, errors, allowance);
    EXPECT_EQ(closeness.shows_untouched(all_outcome_vectors), times < 1) << times;
  }
}

/// An equation depends on a vector if the slope for this vector is not always zero.
TEST(Closeness, KnowsTheVectorsThatAnEquationSpeaksOf) {
  for (const Equation& equation : affine_equations) {
    PerVector<bool> occurs{};
    for (const auto& [family, one] : unit::valid_cases(3)) {
      if (one.collision.a.immovable || one.collision.b.immovable) {
        continue;  // some collisions have no such equation
      }
      const PerVector<double> slopes = slopes_of(equation, one.collision);
      for (const OutcomeVector k : all_outcome_vectors) {
        occurs[k] = occurs[k] || slopes[k] != 0;
      }
    }
    EXPECT_EQ(vectors_in(*name_of(equation)), occurs) << static_cast<int>(*name_of(equation));
  }
}

TEST(Closeness, ShowsNothingWhereNothingIsKnown) {
  EXPECT_FALSE(Closeness().shows(equation::Push{true}));
  EXPECT_FALSE(Closeness().shows(equation::NonPenetration{}));
  EXPECT_FALSE(Closeness().shows(equation::LinearMomentum{}));
  EXPECT_FALSE(Closeness().shows_energy());
  EXPECT_FALSE(Closeness().shows_untouched(all_outcome_vectors));
}

}  // namespace
}  // namespace carom::oracles
