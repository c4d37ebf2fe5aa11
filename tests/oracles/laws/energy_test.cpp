// SPDX-License-Identifier: BSL-1.0
#include <cstdint>
#include <iostream>
#include <string_view>

#include <gtest/gtest.h>

#include <carom/impulse/solve3.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/models/models.hpp>

#include "support/exact.hpp"

/// The exact change of energy by each law, ΔE: the kinetic energy that the movable bodies gain, minus the work of a
/// moving wall (docs/findings/note.md).
namespace carom::oracles {
namespace {

using unit::ExactMatrix;
using unit::ExactVector;
using unit::ratio;

Rational energy_change(const BasicCollision<Rational>& c, const Outcome<Rational>& after) {
  const auto sides = equation::Energy{}(c, after);
  return sides.left[0] - sides.right[0];
}

/// Some contacts do not collide, because the formulas hold for N·V⁻ of either sign.
std::vector<BasicCollision<Rational>> collisions() {
  std::vector<BasicCollision<Rational>> result;
  for (std::uint64_t i = 0; i < 300; ++i) {
    properties::Stream stream = properties::stream_from(9000 + i);
    result.push_back(lift(unit::small_collision(stream)));
  }
  for (const auto& [family, one] : unit::valid_cases(4)) {
    if (family != "both_immovable") {
      result.push_back(lift(one.collision));
    }
  }
  return result;
}

/// ΔE = ½ F·(V⁻ + V⁺), for any impulse F.
TEST(Energy, IsTheWorkOfTheImpulseAtTheMeanVelocity) {
  for (const auto& c : collisions()) {
    for (const Law law : linear_laws) {
      const Truth<Rational> truth = colliding_truth(c, law, Branch::only);
      const ExactVector sum = unit::velocity_before(c) + relative_velocity<Rational>(c, truth.outcome);
      EXPECT_EQ(energy_change(c, truth.outcome), truth.impulse.dot(sum) / 2);
    }
  }
}

TEST(Energy, GainIsTheDifferenceOfTheEnergies) {
  for (const auto& c : collisions()) {
    const Truth<Rational> truth = colliding_truth(c, Law::reflection, Branch::only);
    if (c.a.immovable) {
      continue;
    }
    const auto energy_of = [&](const ExactVector& v, const ExactVector& w) -> Rational {
      return (c.a.mass * v.dot(v) + w.dot(apply_inertia<Rational>(c.a, w))) / 2;
    };
    EXPECT_EQ(kinetic_energy_gain(c.a, truth.outcome.a),
              energy_of(truth.outcome.a.velocity, truth.outcome.a.angular_velocity) -
                  energy_of(c.a.velocity, c.a.angular_velocity));
  }
}

/// Frictionless: ΔE = −(1−ε²)(N·V⁻)²/(2 NᵀKN) ≤ 0.
TEST(Energy, IsLostByTheFrictionlessLawAsTheFormulaSays) {
  for (const auto& c : collisions()) {
    const Rational v_n = c.normal.dot(unit::velocity_before(c));
    const ExactMatrix k = response_matrix(c);
    const Rational change = energy_change(c, colliding_truth(c, Law::frictionless, Branch::only).outcome);
    EXPECT_EQ(change, -(1 - c.restitution * c.restitution) * v_n * v_n / (2 * c.normal.dot(ExactVector(k * c.normal))));
    EXPECT_LE(change, 0);
  }
}

/// Reflection. Let A = K⁻¹ and V⁻ = v_n N + v_t T0, in the basis {N, T0, T1} with ‖N‖ = 1. Then ΔE = (1+ε)/2 · [(ε−1)
/// v_n² A₀₀ − 2 v_n v_t A₀₁]. In any basis, and for N of any length, v_n² A₀₀ = (N·V⁻)² NᵀAN/(N·N)² and v_n v_t A₀₁ =
/// (N·V⁻) NᵀAV_T/(N·N), with the slip V_T.
TEST(Energy, ChangesUnderReflectionAsTheFormulaSays) {
  for (const auto& c : collisions()) {
    const ExactVector n = c.normal;
    const ExactVector v = unit::velocity_before(c);
    const Rational v_n = n.dot(v);
    const Rational length = n.dot(n);
    const ExactVector a_n = impulse::Ldlt::solve<Rational>(response_matrix(c), n);
    const ExactVector v_t = v - n * Rational(v_n / length);
    const Rational first = v_n * v_n * n.dot(a_n) / (length * length);
    const Rational second = v_n * v_t.dot(a_n) / length;
    EXPECT_EQ(energy_change(c, colliding_truth(c, Law::reflection, Branch::only).outcome),
              (1 + c.restitution) / 2 * ((c.restitution - 1) * first - 2 * second));
  }
}

/// At ε = 1, ΔE changes its sign with the slip V_T. So of two contacts with opposite slips, one gains the energy that
/// the other loses.
TEST(Energy, IsCreatedByReflectionInExactlyOneOfTwoOppositeSlips) {
  int created = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    BasicCollision<Rational> c = lift(unit::case_of("elastic", i).collision);
    const Rational change = energy_change(c, colliding_truth(c, Law::reflection, Branch::only).outcome);
    const ExactVector v = unit::velocity_before(c);
    const ExactVector v_t = v - c.normal * Rational(c.normal.dot(v) / c.normal.dot(c.normal));
    c.a.velocity -= v_t * Rational(2);
    EXPECT_EQ(energy_change(c, colliding_truth(c, Law::reflection, Branch::only).outcome), -change);
    created += change != 0 ? 1 : 0;
  }
  EXPECT_GT(created, 90);  // for general bodies, N is an eigenvector of K, or V_T = 0, only by chance
}

int creations(const char* family, int cases) {
  int count = 0;
  for (int i = 0; i < cases; ++i) {
    const BasicCollision<Rational> c = lift(unit::case_of(family, static_cast<std::uint64_t>(i)).collision);
    count += energy_change(c, colliding_truth(c, Law::reflection, Branch::only).outcome) > 0 ? 1 : 0;
  }
  return count;
}

/// If V_T and −V_T are equally likely, half of all contacts create energy. The test allows five standard deviations
/// √(1000/4) = 15.8.
TEST(Energy, IsCreatedByReflectionInAboutHalfOfElasticContacts) { EXPECT_NEAR(creations("elastic", 1000), 500, 79); }

/// ΔE / (1 + ε) grows with ε, because v_n² A₀₀ ≥ 0. So a contact that creates energy at ε = 0 also creates energy at ε
/// = 1.
TEST(Energy, IsCreatedByReflectionAtRestitutionOneWhereverItIsAtZero) {
  int created = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    BasicCollision<Rational> c = lift(unit::case_of("inelastic", i).collision);
    if (energy_change(c, colliding_truth(c, Law::reflection, Branch::only).outcome) > 0) {
      ++created;
      c.restitution = 1;
      EXPECT_GT(energy_change(c, colliding_truth(c, Law::reflection, Branch::only).outcome), 0);
    }
  }
  EXPECT_GT(created, 0);
}

/// At ε = 0, a contact creates energy if 2 v_t A₀₁ > |v_n| A₀₀. A count shows that a quarter of the family `inelastic`
/// does so. The test allows five standard deviations √(1000·3/16) = 13.7.
TEST(Energy, IsCreatedByReflectionInAboutAQuarterOfInelasticContacts) {
  EXPECT_NEAR(creations("inelastic", 1000), 250, 68);
}

/// Sticking: ΔE = ½ (V⁺ᵀ A V⁺ − V⁻ᵀ A V⁻) with A = K⁻¹, and V⁺ = 0 at ε = 0.
TEST(Energy, IsLostByStickingWithoutRestitution) {
  for (BasicCollision<Rational> c : collisions()) {
    c.restitution = 0;
    EXPECT_LE(energy_change(c, colliding_truth(c, Law::sticking, Branch::only).outcome), 0);
  }
}

/// Sticking, with A = K⁻¹. Among all slips with a given N·V⁻, the least V⁻ᵀ A V⁻ is (N·V⁻)²/(NᵀKN). So ΔE ≤ ½ (N·V⁻)²
/// (ε² NᵀAN/(N·N)² − 1/(NᵀKN)). The slip of least V⁻ᵀ A V⁻ attains this bound. The bound is positive if and only if ε²
/// (NᵀAN) (NᵀKN) > (N·N)² and N·V⁻ ≠ 0.
TEST(Energy, IsCreatedByStickingFromARestitutionOn) {
  int can_create = 0;
  for (BasicCollision<Rational> c : collisions()) {
    const ExactVector n = c.normal;
    const ExactMatrix k = response_matrix(c);
    const Rational length = n.dot(n);
    const Rational product = n.dot(impulse::Ldlt::solve<Rational>(k, n)) * n.dot(ExactVector(k * n));
    const ExactVector v = unit::velocity_before(c);
    // The slip of least V⁻ᵀ A V⁻ has V⁻ along K N.
    const ExactVector least = k * n * Rational(n.dot(v) / n.dot(ExactVector(k * n)));
    (c.a.immovable ? c.b : c.a).velocity += (c.a.immovable ? Rational(-1) : Rational(1)) * ExactVector(least - v);
    const Rational change = energy_change(c, colliding_truth(c, Law::sticking, Branch::only).outcome);
    const Rational excess = c.restitution * c.restitution * product - length * length;
    EXPECT_EQ(sign_of(change), n.dot(v) == 0 ? 0 : sign_of(excess));
    can_create += change > 0 ? 1 : 0;
  }
  EXPECT_GT(can_create, 0);
}

/// Sticking pulls (N·F < 0) in some contacts of general bodies. In some contacts with ε > 0, it creates energy. For
/// spheres, it does neither.
TEST(Energy, IsCreatedByStickingInSomeContactsAndPulledInSome) {
  for (const char* family : {"elastic", "inelastic", "physical", "collinear_spheres"}) {
    int creates = 0;
    int pulls = 0;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const BasicCollision<Rational> c = lift(unit::case_of(family, i).collision);
      const Truth<Rational> truth = colliding_truth(c, Law::sticking, Branch::only);
      creates += energy_change(c, truth.outcome) > 0 ? 1 : 0;
      pulls += c.normal.dot(truth.impulse) < 0 ? 1 : 0;
    }
    std::cout << family << ": of 1000 contacts " << creates << " create energy, " << pulls << " pull\n";
    const std::string_view name = family;
    EXPECT_EQ(creates > 0, name == "elastic" || name == "physical");
    EXPECT_EQ(pulls > 0, name != "collinear_spheres");
  }
}

/// Kantorovich's inequality: (NᵀAN) (NᵀKN) ≤ (κ + 1)²/(4κ) (N·N)², with A = K⁻¹ and the condition number κ of K. For
/// convex uniform bodies κ ≤ 16, so (κ + 1)²/(4κ) ≤ (17/8)². So sticking creates no energy for ε ≤ 8/17.
TEST(Energy, IsNeverCreatedByStickingConvexBodiesBelowEightSeventeenths) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    BasicCollision<Rational> c = lift(unit::case_of("physical", i).collision);
    c.restitution = ratio(8, 17);
    EXPECT_LE(energy_change(c, colliding_truth(c, Law::sticking, Branch::only).outcome), 0) << i;
  }
}

}  // namespace
}  // namespace carom::oracles
