// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <carom/oracles/bounds/quantities.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/truths/models.hpp>
#include <carom/oracles/truths/sensitivity.hpp>

#include "support/exact.hpp"
#include "support/known_collisions.hpp"

namespace carom::oracles {
namespace {

using ExactDual = Dual<Radical, collision_inputs>;

/// The branch of the law, as if the contact collided.
Branch branch_of(const Collision& collision, Law law) { return ExactCase(collision).branch(law); }

struct Differentiated {
  Differentiated(const Collision& collision, Law law)
      : truth(colliding_truth(
            dual_inputs<Radical, collision_inputs>(collision, [](double x) { return Radical(x); }).collision, law,
            branch_of(collision, law))) {
    for_each_number(
        [&](const FieldPath& path, const double& x) {
          paths.push_back(path);
          numbers.emplace_back(x);
        },
        collision);
  }

  Truth<ExactDual> truth;
  std::vector<FieldPath> paths;
  std::vector<Radical> numbers;
};

/// The first case of each of these families, and six collisions of small dyadic numbers; fewer if the test is sampled.
std::vector<Collision> binary64_collisions(std::vector<const char*> families) {
  families.resize(static_cast<std::size_t>(unit::effort(static_cast<int>(families.size()))));
  std::vector<Collision> result;
  for (const char* family : families) {
    result.push_back(unit::case_of(family, 0).collision);
  }
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(unit::effort(6)); ++i) {
    properties::Stream stream = properties::stream_from(600 + i);
    result.push_back(unit::small_collision(stream));
  }
  return result;
}

double length_by_definition(const Collision& collision, const FieldPath& of, const std::vector<double>& numbers) {
  double squares = 0;
  for (const double x : numbers) {
    squares += x * x;
  }
  const Body& body = of.body == "a" ? collision.a : collision.b;
  if (of.field != "position" || body.immovable) {
    return std::sqrt(squares);
  }
  const Vector3<double>& moment = body.principal_inertia;
  const double least = std::min(
      {moment[1] + moment[2] - moment[0], moment[2] + moment[0] - moment[1], moment[0] + moment[1] - moment[2]});
  return std::sqrt(squares) + std::sqrt(std::max(least, 0.0) / (2 * body.mass));
}

Sensitivity sensitivity_by_definition(const Collision& collision, Law law) {
  const Differentiated differentiated(collision, law);
  const Outcome<double> before = unchanged(collision);
  Sensitivity result{};
  for (const OutcomeVector k : all_outcome_vectors) {
    const Vector3<ExactDual>& y = *vectors(differentiated.truth.outcome)[k];
    result[k] = vectors(before)[k]->norm();
    for (std::size_t j = 0; j < differentiated.numbers.size();) {
      const FieldPath& of = differentiated.paths[j];
      std::vector<double> numbers;
      double squares = 0;
      do {
        for (int i = 0; i < 3; ++i) {
          squares += std::pow(to_double(y[i].derivative[j]), 2);
        }
        numbers.push_back(to_double(differentiated.numbers[j]));
        ++j;
      } while (of.field != "principal_inertia" && j < differentiated.paths.size() &&
               differentiated.paths[j].field == of.field && differentiated.paths[j].body == of.body);
      result[k] += std::sqrt(squares) * length_by_definition(collision, of, numbers);
    }
  }
  return result;
}

void expect_by_definition(const ExactCase& exact_case, Law law, double relative) {
  ASSERT_EQ(exact_case.state(), ContactState::colliding);
  const Sensitivity expected = sensitivity_by_definition(exact_case.collision(), law);
  const Sensitivity& actual = exact_case.sensitivity(law, 0);
  for (const OutcomeVector k : all_outcome_vectors) {
    EXPECT_NEAR(actual[k], expected[k], relative * expected[k]) << name_of(law) << ' ' << name_of(k);
  }
}

/// In binary64, each operation adds a relative error of up to κ(K) u. Here κ(K) is the condition number of K, below
/// 2²⁰. A sum takes fewer than 2⁷ successive operations, so its relative error is below 2^(20 + 7 − 53).
TEST(Sensitivity, IsTheSumOfTheExactDerivatives) {
  int colliding = 0;
  for (const Collision& collision :
       binary64_collisions({"elastic", "near_head_on", "driven_wall", "sliding", "sticking", "mass_ratio",
                            "far_from_origin", "collinear_spheres", "long_normal"})) {
    const ExactCase exact_case(collision);
    if (exact_case.state() != ContactState::colliding) {
      continue;
    }
    ++colliding;
    for (const Law law : laws_with_truth) {
      expect_by_definition(exact_case, law, 0x1p-26);
    }
  }
  EXPECT_GE(colliding, unit::effort(6));
}

struct EnclosedSensitivity {
  Sensitivity below;
  Sensitivity above;
};

/// The bounds are far apart if the terms of a derivative cancel, as in the spin of a needle.
EnclosedSensitivity sensitivity_by_forward_differentiation(const Collision& collision, Law law, Branch branch) {
  const auto inputs = unit::enclosed_inputs(collision);
  const auto truth = colliding_truth(inputs.collision, law, branch);
  EnclosedSensitivity result{norms_before(collision), norms_before(collision)};
  for (const OutcomeVector k : all_outcome_vectors) {
    const auto& y = *vectors(truth.outcome)[k];
    result.below[k] += unit::sensitivity_by(&Enclosure::magnitude_below, {&y[0], &y[1], &y[2]}, inputs.quantities);
    result.above[k] += unit::sensitivity_by(&Enclosure::magnitude_above, {&y[0], &y[1], &y[2]}, inputs.quantities);
  }
  return result;
}

void expect_within(double x, double below, double above, double relative, const std::string& what) {
  EXPECT_GE(x, (1 - relative) * below) << what;
  EXPECT_LE(x, (1 + relative) * above) << what;
}

/// 1 + Σ (‖r‖² / min I) / λ over the movable bodies, with λ = 1/m_A + 1/m_B. This number is at least κ(K).
double growth(const Collision& c) {
  double lambda = 0;
  double arms = 0;
  for (const Body* body : {&c.a, &c.b}) {
    if (!body->immovable) {
      lambda += 1 / body->mass;
      arms += (c.point - body->position).squaredNorm() / body->principal_inertia.minCoeff();
    }
  }
  return 1 + arms / lambda;
}

/// Binary64 makes fewer than 2⁹ roundings, which grow by the factor `growth`. The constant part covers κ(K) < 2²⁰.
TEST(Sensitivity, IsTheSameByImplicitDifferentiation) {
  int compared = 0;
  for (const auto& [family, one] : unit::sampled_cases(20)) {
    const ExactCase exact_case(one.collision);
    if (exact_case.state() != ContactState::colliding || !exact_case.is_moderate()) {
      continue;
    }
    const Matrix3<double> k =
        exact_case.enclosed_collision_matrix().unaryExpr([](const auto& x) { return x.middle(); });
    if (k.trace() * k.trace() * k.trace() > 0x1p+22 * k.determinant()) {
      continue;
    }
    for (const Law law : laws_with_truth) {
      const Branch branch = exact_case.branch(law);
      if (branch == Branch::on_cone && !exact_case.has_clear_divisor()) {
        continue;
      }
      const std::optional<Sensitivity> quick = colliding_sensitivity(one.collision, law, branch);
      const std::optional<Sensitivity> enclosed = enclosed_sensitivity(one.collision, law, branch, true);
      const EnclosedSensitivity whole = sensitivity_by_forward_differentiation(one.collision, law, branch);
      const double relative = 0x1p-24 + growth(one.collision) * 0x1p-44;
      EXPECT_EQ(quick.has_value(), growth(one.collision) <= 0x1p+34) << family;
      ASSERT_TRUE(enclosed) << family;
      ++compared;
      for (const OutcomeVector vector : all_outcome_vectors) {
        const std::string what =
            std::string(family).append(" ").append(name_of(law)).append(" ").append(name_of(vector));
        if (quick) {
          expect_within((*quick)[vector], whole.below[vector], whole.above[vector], relative, what);
        }
        // Sums of fewer than 2^8 roundings.
        expect_within((*enclosed)[vector], whole.below[vector], whole.above[vector], 0x1p-45, what);
      }
    }
  }
  EXPECT_GT(compared, unit::effort(400));
}

/// Double-double arithmetic makes fewer than 2⁹ roundings of 2⁻¹⁰². Their relative error grows by the factor `growth`.
/// Binary64 adds eight roundings.
TEST(Sensitivity, IsKnownWhereTheMatrixIsNearlySingular) {
  std::size_t compared = 0;
  std::size_t unknown_by_radii = 0;
  for (const char* family : {"far_contacts", "impossible_moments"}) {
    for (std::uint64_t i = 0; i < 8; ++i) {
      const Collision collision = unit::case_of(family, i).collision;
      const ExactCase exact_case(collision);
      if (exact_case.state() != ContactState::colliding || growth(collision) > 0x1p+82) {
        continue;
      }
      for (const Law law : linear_laws) {
        const std::optional<Sensitivity> enclosed = enclosed_sensitivity(collision, law, Branch::only, true);
        ASSERT_TRUE(enclosed) << family << ' ' << i << ' ' << name_of(law);
        unknown_by_radii += enclosed_sensitivity(collision, law, Branch::only, false) ? 0 : 1;
        const Sensitivity expected = exact_sensitivity(collision, law, Branch::only);
        ++compared;
        for (const OutcomeVector vector : all_outcome_vectors) {
          EXPECT_NEAR((*enclosed)[vector], expected[vector], (0x1p-49 + growth(collision) * 0x1p-93) * expected[vector])
              << family << ' ' << i << ' ' << name_of(law) << ' ' << name_of(vector);
        }
      }
    }
  }
  EXPECT_GT(compared, 30U);
  EXPECT_GT(unknown_by_radii, 2U);
}

TEST(Sensitivity, IsNoneWhereRoundingsGrowTooMuch) {
  Collision c;
  c.a.orientation = {3, 1, 2, 1};
  c.a.position = {1, 2, -1};
  c.a.velocity = {0.25, -1, 0.5};
  c.b.immovable = true;
  for (const int exponent : {-60, -80, -81, -100}) {
    c.a.principal_inertia = {1, std::ldexp(1.0, exponent), 1};
    EXPECT_EQ(enclosed_sensitivity(c, Law::reflection, Branch::only, true).has_value(), growth(c) <= 0x1p+83)
        << exponent;
  }
}

/// On the surface of the friction cone, `rough` divides by a difference, whose terms cancel here. Double-double
/// arithmetic does not keep three digits, although κ(K) is below 2⁶⁶.
TEST(Sensitivity, IsNoneWhereTheDivisorOfFrictionCancels) {
  Collision c;
  c.a.principal_inertia = {4.8104236488202286e-20, 1, 1.25};
  c.a.orientation = {-0.7223201996990147, 0.15352823206456945, 0.9841789619845829, 0.771501281995215};
  c.a.position = {-1.5072686229811976, 1.824354217871167, 0.559232951278922};
  c.a.velocity = {0.5617883679682821, -0.82516280373387, -0.05916229330910643};
  c.b.immovable = true;
  c.point = {-0.9454802545631791, 0.9991914144959995, 0.5000706572374007};
  c.normal = {-0.5617883684180185, 0.8251628033751675, 0.05916229404152128};
  c.restitution = 0.5;
  c.friction = 4.967053818694609e-10;
  c.tangential_restitution = 0.75;
  ASSERT_EQ(ExactCase(c).branch(Law::rough), Branch::on_cone);
  EXPECT_FALSE(ExactCase(c).is_moderate(Law::rough));
  ASSERT_LT(growth(c), 0x1p+66);
  EXPECT_FALSE(enclosed_sensitivity(c, Law::rough, Branch::on_cone, true));
}

/// If the lever arm is zero, K is λI, so no rounding of K grows.
TEST(Sensitivity, GrowsByNothingForACentralContactWithAWall) {
  Collision c;
  c.b.immovable = true;
  EXPECT_EQ(growth_in_collision_matrix(c), 1);
}

/// Masses in another unit change no velocity. The length of the normal is free, and N·V⁻ grows with it.
TEST(SecondOrderFromRest, DependsOnRestitutionAndNeitherOnUnitsOfMassNorOnTheLengthOfTheNormal) {
  const Collision c = unit::plain_collision();
  const Sensitivity scale = second_order_from_rest(c, 3);
  Collision heavy = c;
  for (Body* body : {&heavy.a, &heavy.b}) {
    body->mass *= 8;
    body->principal_inertia *= 8;
  }
  Collision long_normal = c;
  long_normal.normal *= 4;
  Collision elastic = c;
  elastic.restitution = 1;
  Collision inelastic = c;
  inelastic.restitution = 0;
  for (const OutcomeVector k : all_outcome_vectors) {
    EXPECT_GT(scale[k], 0);
    EXPECT_EQ(second_order_from_rest(heavy, 3)[k], scale[k]);
    EXPECT_EQ(second_order_from_rest(long_normal, 4 * 3)[k], scale[k]);
    EXPECT_EQ(second_order_from_rest(elastic, 3)[k], 2 * second_order_from_rest(inelastic, 3)[k]);
  }
}

/// A change of units multiplies masses by 2⁶⁰⁰ and velocities by 2³⁰⁰.
TEST(Sensitivity, HasNoUnits) {
  const ExactCase plain(unit::plain_collision());
  Collision scaled = plain.collision();
  for (Body* body : {&scaled.a, &scaled.b}) {
    body->mass *= 0x1p+600;
    body->principal_inertia *= 0x1p+600;
    body->velocity *= 0x1p+300;
    body->angular_velocity *= 0x1p+300;
  }
  const ExactCase huge(scaled);
  for (const Law law : laws_with_truth) {
    for (const double allowance : {0x1p-48, 0x1p-19, 0x1p-6}) {
      const Sensitivity of_plain = plain.sensitivity(law, allowance);
      const Sensitivity of_huge = huge.sensitivity(law, allowance);
      for (const OutcomeVector k : all_outcome_vectors) {
        // A sensitivity must be accurate to a thousandth.
        EXPECT_NEAR(of_huge[k], std::ldexp(of_plain[k], 300), 0x1p-10 * of_huge[k])
            << name_of(law) << ' ' << allowance << ' ' << name_of(k);
      }
    }
  }
}

/// The lever arm is along the normal up to rounding, and long compared with √(I/m). Binary64 keeps no digit of r × N.
TEST(Sensitivity, IsKnownWhereTheLeverArmIsAlongTheNormal) {
  for (const double length : {1.0, 1e3, 1e6}) {
    Collision c;
    c.normal = {0.1, 0.3, 0.7};
    c.point = {0.2, -0.4, 0.5};
    c.a.principal_inertia = {1e-19, 2e-19, 3e-19};
    c.a.orientation = {3, 1, 2, 1};
    c.a.position = c.point + length * c.normal;
    c.a.velocity = {0.25, -1, -0.5};
    c.a.angular_velocity = {1, 2, -3};
    c.b.immovable = true;
    expect_by_definition(ExactCase(c), Law::frictionless, 0x1p-26);
  }
}

TEST(Sensitivity, IsAtLeastItsLowerBound) {
  int moderate = 0;
  for (const auto& [family, one] : unit::sampled_cases(20)) {
    const ExactCase exact_case(one.collision);
    for (const Law law : laws_with_truth) {
      if (!exact_case.is_moderate(law)) {
        continue;
      }
      ++moderate;
      const Sensitivity below = exact_case.sensitivity_below(law);
      const Sensitivity& all = exact_case.sensitivity(law, 0x1p-48);
      for (const OutcomeVector k : all_outcome_vectors) {
        EXPECT_LE(below[k], all[k]) << family << ' ' << name_of(k);
      }
    }
  }
  EXPECT_GT(moderate, unit::effort(1000));
}

/// If nothing happens, y = y⁻. ∂y/∂y⁻ = I has the Frobenius norm √3, so the sensitivity is √3 ‖y‖ + ‖y‖.
TEST(Sensitivity, IsThatOfTheIdentityWhereNothingHappens) {
  const Collision c = unit::case_of("separating", 0).collision;
  const ExactCase exact_case(c);
  ASSERT_FALSE(exact_case.is_grazing(0x1p-48));
  const Sensitivity& actual = exact_case.sensitivity(Law::frictionless, 0x1p-48);
  const Vector3<double>& v = c.b.velocity;
  const double expected = (std::sqrt(3.0) + 1) * std::sqrt(v.dot(v));
  // The tolerance covers eight roundings, and a term of second order: the allowance times the change that an impulse
  // could make.
  EXPECT_NEAR(actual[OutcomeVector::velocity_of_b], expected, 0x1p-50 * expected + 0x1p-48 * 64 * expected);
}

/// N = (1, 1, 0) and V⁻ = (1, −1 ± 2⁻⁴⁰, 0), so N·V⁻ = ±2⁻⁴⁰. The sensitivity of N·V⁻ is ‖V⁻‖ ‖N‖ + ‖N‖ ‖v_A‖, about 4.
TEST(Grazing, MeansThatPermittedInputsChangeTheSignOfTheNormalVelocity) {
  for (const double side : {-1.0, 1.0}) {
    Collision c;
    c.normal = {1, 1, 0};
    c.a.velocity = {1, -1 + side * 0x1p-40, 0};
    const ExactCase exact_case(c);
    EXPECT_EQ(exact_case.state(), side < 0 ? ContactState::colliding : ContactState::separating);
    EXPECT_TRUE(exact_case.is_grazing(0x1p-41));
    EXPECT_FALSE(exact_case.is_grazing(0x1p-43));
    EXPECT_FALSE(exact_case.is_grazing(0));
  }
}

TEST(Grazing, TakesEveryDerivativeOfTheNormalVelocity) {
  int seen = 0;
  for (const auto& [family, one] : unit::valid_cases(4)) {
    const ExactCase exact_case(one.collision);
    const auto& inputs = exact_case.differentiated();
    const auto velocity = normal_velocity_before(inputs.collision);
    const double sensitivity = sensitivity_of({&velocity}, inputs.quantities);
    EXPECT_NEAR(exact_case.normal_velocity_sensitivity(), sensitivity, 0x1p-40 * sensitivity) << family;
    const double edge = std::abs(velocity.value) / sensitivity;
    // The test skips N·V⁻ near 0, because its rounding moves the edge. It also skips hard cases, where an enclosure
    // decides instead.
    if (exact_case.state() == ContactState::inert || !(edge > 0x1p-20) ||
        exact_case.permitted_inputs(edge * (1 - 0x1p-20)) != nullptr) {
      continue;
    }
    EXPECT_TRUE(exact_case.is_grazing(edge * (1 + 0x1p-20))) << family;
    EXPECT_FALSE(exact_case.is_grazing(edge * (1 - 0x1p-20))) << family;
    ++seen;
  }
  EXPECT_GE(seen, 4);
}

/// The derivative of N·V⁻ by A's position exceeds binary64, but this position is zero and contributes nothing.
TEST(Grazing, IgnoresInputsThatAreZero) {
  Collision c;
  c.normal = {1e200, 0, 0};
  c.a.immovable = true;
  c.a.angular_velocity = {0, 1e200, 0};
  c.a.velocity = {1, 0, 0};
  c.b.velocity = {1 + 0x1p-52, 0, 0};
  const ExactCase exact_case(c);
  EXPECT_EQ(exact_case.state(), ContactState::colliding);
  EXPECT_TRUE(exact_case.is_grazing(0x1p-48));
  EXPECT_FALSE(exact_case.is_grazing(0x1p-56));
}

/// A contact that separates by less than the allowance has the sensitivity of a collision.
TEST(Grazing, TakesTheSensitivityOfTheCollidingAnswer) {
  Collision c;
  c.normal = {1, 1, 0};
  c.a.velocity = {1, -1 + 0x1p-40, 0};
  const ExactCase exact_case(c);
  const double colliding = exact_case.sensitivity(Law::frictionless, 0x1p-41)[OutcomeVector::velocity_of_b];
  const double untouched = exact_case.sensitivity(Law::frictionless, 0)[OutcomeVector::velocity_of_b];
  EXPECT_EQ(untouched, 0);  // B is at rest and stays so
  EXPECT_GT(colliding, 1);  // of order ‖V‖
}

}  // namespace
}  // namespace carom::oracles
