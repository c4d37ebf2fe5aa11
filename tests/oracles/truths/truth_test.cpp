// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/laws/certify.hpp>
#include <carom/oracles/truths/models.hpp>

#include "support/cases.hpp"
#include "support/exact.hpp"
#include "support/message_of.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;
using unit::same;

TEST(Truth, RefusesTheLawThatDeterminesNoOutcome) {
  const BasicCollision<Rational> exact = lift(unit::case_of("generic", 0).collision);
  EXPECT_EQ(unit::message_of<std::invalid_argument>([&] { return colliding_truth(exact, Law::any, Branch::only); }),
            "the law `any` determines no outcome");
}

/// A ball of mass 2 and moments 1 falls with (1, −4, 0) on a fixed plane, ε = 1/2. Without friction F = (0, 12, 0) and
/// the ball leaves with (1, 2, 0). If the ball sticks, K F = (−1, 6, 0) with K = diag(3/2, 1/2, 3/2).
TEST(Truth, OfAFallingBallIsThatOfATextbook) {
  Collision c;
  c.a.mass = 2;
  c.a.position = {0, 1, 0};
  c.a.velocity = {1, -4, 0};
  c.b.immovable = true;
  c.restitution = 0.5;
  const ExactCase exact_case(c);
  for (const Law law : {Law::frictionless, Law::reflection}) {
    const Truth<Rational>& truth = exact_case.truth(law);
    EXPECT_TRUE(same(truth.impulse, unit::ExactVector(0, 12, 0))) << name_of(law);
    EXPECT_TRUE(same(truth.outcome.a.velocity, unit::ExactVector(1, 2, 0)));
    EXPECT_TRUE(same(truth.outcome.a.angular_velocity, unit::ExactVector(0, 0, 0)));
  }
  const Truth<Rational>& sticking = exact_case.truth(Law::sticking);
  EXPECT_TRUE(same(sticking.impulse, unit::ExactVector(ratio(-2, 3), 12, 0)));
  EXPECT_TRUE(same(sticking.outcome.a.velocity, unit::ExactVector(ratio(2, 3), 2, 0)));
  EXPECT_TRUE(same(sticking.outcome.a.angular_velocity, unit::ExactVector(0, 0, ratio(-2, 3))));
}

TEST(ContactState, IsTheSignOfTheExactNormalVelocity) {
  for (const auto& [family, one] : unit::valid_cases(30)) {
    const Collision& c = one.collision;
    const Rational normal_velocity = lift(c).normal.dot(unit::velocity_before(lift(c)));
    const ContactState approach = ExactCase(c).state();
    if (c.a.immovable && c.b.immovable) {
      EXPECT_EQ(approach, ContactState::inert) << family;
    } else {
      EXPECT_EQ(approach, normal_velocity < 0    ? ContactState::colliding
                          : normal_velocity == 0 ? ContactState::resting
                                                 : ContactState::separating)
          << family;
    }
  }
}

/// N·V⁻ is ±2⁻¹⁵⁰ or 0, and its terms are about 0.1. Double-double numbers have too few bits for such a sum.
TEST(ContactState, IsDecidedExactlyWhereEnclosuresCannot) {
  for (const int sign : {-1, 0, 1}) {
    Collision c;
    c.normal = {1, 1, std::ldexp(1.0, -75)};
    c.a.velocity = {0.1, -0.1, sign * std::ldexp(1.0, -75)};
    const ContactState expected = sign < 0    ? ContactState::colliding
                                  : sign == 0 ? ContactState::resting
                                              : ContactState::separating;
    EXPECT_EQ(ExactCase(c).state(), expected) << sign;
  }
}

std::vector<Collision> contacts_to_certify() {
  std::vector<Collision> contacts;
  for (const char* family : {"elastic", "inelastic", "immovable_a", "immovable_b", "driven_wall", "zero_lever"}) {
    contacts.push_back(unit::case_of(family, 0).collision);
  }
  return contacts;
}

void expect_every_corruption_noticed(const BasicCollision<Rational>& exact, Law law, ContactState approach,
                                     const Outcome<Rational>& outcome) {
  EXPECT_NO_THROW(certify(exact, law, approach, outcome));
  for (const int exponent : {-200, 0, 100}) {
    for (const OutcomeVector k : all_outcome_vectors) {
      for (int i = 0; i < 3; ++i) {
        Outcome<Rational> corrupted = outcome;
        (*vectors(corrupted)[k])[i] += Rational(std::ldexp(1.0, exponent));
        EXPECT_THROW(certify(exact, law, approach, corrupted), JudgeError)
            << name_of(k) << '[' << i << "] by 2^" << exponent;
      }
    }
  }
}

TEST(Certify, NoticesEachCorruptedComponent) {
  for (const Collision& collision : contacts_to_certify()) {
    const ExactCase exact_case(collision);
    ASSERT_EQ(exact_case.state(), ContactState::colliding);
    for (const Law law : linear_laws) {
      expect_every_corruption_noticed(exact_case.exact(), law, ContactState::colliding, exact_case.truth(law).outcome);
    }
  }
}

TEST(Certify, NoticesEachCorruptedComponentWhereNothingHappens) {
  for (const char* family : {"separating", "resting", "both_immovable"}) {
    const ExactCase exact_case(unit::case_of(family, 1).collision);
    expect_every_corruption_noticed(exact_case.exact(), Law::reflection, exact_case.state(),
                                    unchanged(exact_case.exact()));
  }
}

/// An enclosure of some 100 bits refutes an error of 2⁻⁷⁰ of the largest velocity.
TEST(Certify, RefutesEachCorruptedComponentOfAnEnclosedTruth) {
  for (const Collision& collision : contacts_to_certify()) {
    const ExactCase exact_case(collision);
    const BasicCollision<Enclosure>& enclosed = exact_case.enclosed();
    for (const Law law : linear_laws) {
      EXPECT_NO_THROW(exact_case.check_enclosed_truth(law, ContactState::colliding));
      const Outcome<Enclosure>& outcome = exact_case.enclosed_truth(law).outcome;
      EXPECT_EQ(first_refuted(collision, enclosed, law, ContactState::colliding, outcome), nullptr);
      double largest = 0;
      for (const Vector3<Enclosure>* v : vectors(outcome)) {
        for (const Enclosure& x : *v) {
          largest = std::max(largest, std::abs(x.middle()));
        }
      }
      for (const OutcomeVector k : all_outcome_vectors) {
        for (int i = 0; i < 3; ++i) {
          Outcome<Enclosure> corrupted = outcome;
          (*vectors(corrupted)[k])[i] += Enclosure(largest * 0x1p-70);
          EXPECT_NE(first_refuted(collision, enclosed, law, ContactState::colliding, corrupted), nullptr)
              << name_of(k) << '[' << i << ']';
        }
      }
    }
  }
}

std::string reproach(const BasicCollision<Rational>& exact, Law law, const Outcome<Rational>& outcome) {
  return unit::message_of<JudgeError>([&] { certify(exact, law, ContactState::colliding, outcome); });
}

/// Each outcome violates one equation of the law, and the certificate names this equation.
TEST(Certify, NeedsEachEquation) {
  const ExactCase exact_case(unit::case_of("elastic", 0).collision);
  const BasicCollision<Rational>& c = exact_case.exact();
  ASSERT_EQ(c.restitution, 1);
  const auto missed = [&](Law law, const Outcome<Rational>& outcome) { return reproach(c, law, outcome); };
  for (const Law law : linear_laws) {
    // A spin about the lever arm does not move the contact point.
    Outcome<Rational> outcome = exact_case.truth(law).outcome;
    outcome.a.angular_velocity += lever_arm(c.a, c.point);
    EXPECT_EQ(missed(law, outcome), "the truth does not satisfy the angular momentum of A");
    outcome = exact_case.truth(law).outcome;
    outcome.b.angular_velocity += lever_arm(c.b, c.point);
    EXPECT_EQ(missed(law, outcome), "the truth does not satisfy the angular momentum of B");
    // Only A gets an impulse, as if B were a wall. So every condition on A and on V⁺ holds.
    BasicCollision<Rational> other = c;
    other.b.immovable = true;
    EXPECT_EQ(missed(law, colliding_truth(other, law, Branch::only).outcome),
              "the truth does not satisfy linear momentum");
    // The answer for another ε conserves every momentum.
    other = c;
    other.restitution = ratio(99, 100);
    EXPECT_EQ(missed(law, colliding_truth(other, law, Branch::only).outcome), "the truth does not satisfy restitution");
  }
  EXPECT_EQ(missed(Law::frictionless, exact_case.truth(Law::reflection).outcome),
            "the truth does not satisfy the frictionless direction");
  EXPECT_EQ(missed(Law::reflection, exact_case.truth(Law::frictionless).outcome),
            "the truth does not satisfy the reflection plane");
}

TEST(Certify, NeedsTheImmovableBodyToBeUntouched) {
  for (const bool a_is_fixed : {true, false}) {
    const ExactCase exact_case(unit::case_of(a_is_fixed ? "immovable_a" : "immovable_b", 0).collision);
    const BasicCollision<Rational>& c = exact_case.exact();
    for (const Law law : linear_laws) {
      Outcome<Rational> outcome = exact_case.truth(law).outcome;
      BodyVelocity<Rational>& wall = a_is_fixed ? outcome.a : outcome.b;
      wall.angular_velocity += lever_arm(a_is_fixed ? c.a : c.b, c.point);
      EXPECT_EQ(reproach(c, law, outcome), std::string("the truth does not satisfy the immovable ") +
                                               (a_is_fixed ? "A" : "B") + " being untouched");
    }
  }
}

}  // namespace
}  // namespace carom::oracles
