// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdint>
#include <iostream>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/laws.hpp>
#include <carom/impulse/refined.hpp>
#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/judge/compare.hpp>

#include "support/cases.hpp"

/// A body that is struck on its tip along its lever arm. The collision matrix K has the eigenvalue λ = 1/m_A + 1/m_B
/// along N, and eigenvalues up to 16 λ across N.
namespace carom::impulse {
namespace {

using oracles::Rational;

template <class S>
class Tips : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Tips, Scalars);

/// The residual of N·V⁺ = −ε N·V⁻, in ulps of S.
template <class S>
double missed_restitution(const oracles::ExactCase& one, const Outcome<S>& outcome) {
  constexpr double least_that_is_shown = 0x1p-10;
  const auto yardstick = oracles::Yardstick::of(precision_of<S>, {least_that_is_shown});
  const oracles::Comparison comparison = oracles::compare(
      oracles::equation::Restitution{}, oracles::Relation::equal, one,
      oracles::LiftedOutcome(map_outcome<long double>(outcome, [](S x) { return static_cast<long double>(x); })),
      yardstick);
  return comparison.holds ? 0 : least_that_is_shown * comparison.residual / comparison.allowed;
}

/// The cases of `needle_tip` without those in which the rounding of the positions decides the outcome.
template <class S>
std::vector<Collision> struck_tips(std::uint64_t count) {
  constexpr double allowance = oracles::default_limit_ulps * std::numeric_limits<S>::epsilon() / 2;
  std::vector<Collision> tips;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Collision c = unit::case_of("needle_tip", i).collision;
    if (oracles::ExactCase(c).permitted_inputs(allowance) == nullptr) {
      tips.push_back(c);
    }
  }
  return tips;
}

template <class S, class Solver>
double worst_missed_restitution(const std::vector<Collision>& tips, const Solver& solver) {
  double worst = 0;
  for (const Collision& c : tips) {
    const Contact<S> contact = make_contact<S>(c);
    worst = std::max(worst, missed_restitution(oracles::ExactCase(c), apply_impulse(contact, solver(contact))));
  }
  return worst;
}

/// Reflection by one solve without refinement.
template <class S>
ContactImpulse<S> solved_once(const Contact<S>& contact) {
  const S approach = normal_velocity(contact);
  const Vector3<S> change =
      contact.normal * S(-(S(1) + contact.restitution) * approach / dot(contact.normal, contact.normal));
  return contact_impulse(contact, approach < S(0),
                         Ldlt::solve<S>(collision_matrix(contact), change, inverse_mass(contact)));
}

TYPED_TEST(Tips, HoldTheRestitution) {
  const std::vector<Collision> tips = struck_tips<TypeParam>(4000);
  const double once = worst_missed_restitution<TypeParam>(tips, solved_once<TypeParam>);
  std::cout << "worst residual of N·V⁺ in " << tips.size() << " cases: reflection solved once " << once << " ulps";
  for (const Law law : {Law::reflection, Law::sticking, Law::rough}) {
    with_law(law, [&](const auto& solver) {
      const double worst = worst_missed_restitution<TypeParam>(tips, solver);
      std::cout << ", " << name_of(law) << ' ' << worst;
      EXPECT_GT(worst, 0) << name_of(law);
      EXPECT_LT(worst, oracles::default_limit_ulps * 3 / 8) << name_of(law);
      if (law == Law::reflection) {
        EXPECT_LT(worst, once);
      }
    });
  }
  std::cout << '\n';
}

/// The error of J⁻¹ (r × F) × r would be thousands of ulps.
TYPED_TEST(Tips, RespondAsInExactArithmetic) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Contact<TypeParam> contact = make_contact<TypeParam>(unit::case_of("needle_tip", i).collision);
    const Contact<Rational> exact = rounded<Rational>(contact);
    const Vector3<Rational> expected = response(exact, exact.normal);
    const Vector3<TypeParam> computed = response(contact, contact.normal);
    double error = 0;
    double size = 0;
    for (int k = 0; k < 3; ++k) {
      error += std::abs(oracles::to_double(Rational(Rational(computed[k]) - expected[k])));
      size += std::abs(oracles::to_double(expected[k]));
    }
    // K has eigenvalues up to 16 λ, and K N is at least λ N. A sum of products has an error of a few roundings.
    EXPECT_LT(error, 4 * 16 * size * std::numeric_limits<TypeParam>::epsilon() / 2) << i;
  }
}

/// A matrix that is singular up to rounding gives no correction, so the impulse stays that of the solve.
TEST(SolvedImpulse, KeepsTheSolutionIfTheCorrectionIsLong) {
  Contact<double> contact = make_contact<double>(unit::ball_on_a_plane(0.5, 0));
  const Matrix3<double> wrong = Matrix3<double>::Identity() * 64;
  const Vector3<double> change{1, 2, 3};
  EXPECT_EQ((solved_impulse<Ldlt>(contact, wrong, change)), (Ldlt::solve<double>(wrong, change, 1)));
}

/// The matrix is 2 % too large, and the change lies along N, where K is small.
TEST(SolvedImpulse, IsRefinedAgainstTheResponseOfTheBodies) {
  Collision c;
  c.b.immovable = true;
  c.a.position = {0, 1, 0};
  c.a.principal_inertia.setConstant(0.05);  // K = diag(21, 1, 21)
  c.a.velocity = {0, -1, 0};
  const Contact<double> contact = make_contact<double>(c);
  const Matrix3<double> exact = collision_matrix(contact);
  const Vector3<double> change{0.125, 2, 0.25};
  const Matrix3<double> greater = exact * 1.02;
  const Vector3<double> impulse = solved_impulse<Ldlt>(contact, greater, change);
  const Vector3<double> missed = exact * impulse - change;
  EXPECT_LT(missed.norm(), 0.001 * change.norm());  // 0.02² of the change, in place of 0.02
  EXPECT_GT(missed.norm(), 0.0001 * change.norm());
}

}  // namespace
}  // namespace carom::impulse
