// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/gate/answers.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/exact.hpp"

/// Relations that change only signs, exponents, or the names A and B. A solver rounds corresponding numbers alike, so
/// the outcomes correspond bit for bit, except for the sign of zeros. The solvers are compiled with -ffp-contract=off,
/// because a fused x·y + z rounds only one of two products that a relation exchanges.
namespace carom::properties {
namespace {

struct Relation {
  std::function<Collision(Collision)> of_collision;
  std::function<Outcome<long double>(Outcome<long double>)> of_outcome;
};

Relation swap() {
  const auto swapped = [](auto pair) {
    std::swap(pair.a, pair.b);
    return pair;
  };
  return {[swapped](const Collision& collision) {
            Collision result = swapped(collision);
            result.normal = -collision.normal;
            return result;
          },
          swapped};
}

/// The mirror that reverses one axis.
Relation mirror(int axis) {
  const auto polar = [axis](auto v) {
    v[axis] = -v[axis];
    return v;
  };
  const auto axial = [polar](const auto& v) { return std::decay_t<decltype(v)>(-polar(v)); };
  return {[=](Collision c) {
            for (Body* body : {&c.a, &c.b}) {
              body->position = polar(body->position);
              body->velocity = polar(body->velocity);
              body->angular_velocity = axial(body->angular_velocity);
              body->orientation.tail<3>() = axial(Vector3<double>(body->orientation.tail<3>()));
            }
            c.point = polar(c.point);
            c.normal = polar(c.normal);
            return c;
          },
          [=](Outcome<long double> y) {
            for (auto* motion : {&y.a, &y.b}) {
              motion->velocity = polar(motion->velocity);
              motion->angular_velocity = axial(motion->angular_velocity);
            }
            return y;
          }};
}

/// Multiplies the numbers of kg, m and s by 2^mass, 2^length and 2^time.
Relation units_changed_by(int mass, int length, int time) {
  const auto power = [](int exponent) { return std::ldexp(1.0, exponent); };
  return {[=](Collision c) {
            for (Body* body : {&c.a, &c.b}) {
              body->mass *= power(mass);
              body->principal_inertia *= power(mass + 2 * length);
              body->position *= power(length);
              body->velocity *= power(length - time);
              body->angular_velocity *= power(-time);
            }
            c.point *= power(length);
            return c;
          },
          [=](Outcome<long double> y) {
            for (auto* motion : {&y.a, &y.b}) {
              motion->velocity *= power(length - time);
              motion->angular_velocity *= power(-time);
            }
            return y;
          }};
}

/// The valid cases of every family but `structured`, whose sizes underflow in binary32.
std::vector<Collision> collisions() {
  std::vector<Collision> all;
  for (const auto& [family, one] : unit::valid_cases(20)) {
    if (family != "structured") {
      all.push_back(one.collision);
    }
  }
  return all;
}

/// How many outcomes of related collisions are not exactly the related outcome.
std::size_t differences(const Subject& subject, const Relation& relation) {
  const std::vector<Collision> original = collisions();
  std::vector<Collision> related;
  for (const Collision& collision : original) {
    related.push_back(relation.of_collision(collision));
  }
  Session session = subject.open();
  const std::vector<Answer> answers = answers_of(session, original);
  const std::vector<Answer> of_related = answers_of(session, related);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < original.size(); ++i) {
    const Outcome<long double> expected = relation.of_outcome(std::get<ReportedOutcome>(answers[i]));
    differing += unit::same<long double>(expected, std::get<ReportedOutcome>(of_related[i])) ? 0 : 1;
  }
  return differing;
}

/// Expects no difference for the sound built-in solvers, except for those with this word in their name, which must
/// show some.
void expect_bit_for_bit(const std::vector<Relation>& relations, const std::string& except = "no such name") {
  for (const Subject& subject : subjects::built_in_subjects()) {
    if (!subject.expected_to_pass) {
      continue;
    }
    std::size_t differing = 0;
    for (const Relation& relation : relations) {
      differing += differences(subject, relation);
    }
    const bool is_exception = subject.name.find(except) != std::string::npos;
    EXPECT_EQ(differing > 0, is_exception) << subject.name;
  }
}

/// A solver combines numbers of A and B as x_A − x_B, whose sign changes, or as x_A + x_B, which is commutative.
TEST(BitForBit, Swap) { expect_bit_for_bit({swap()}); }

/// A mirror changes the sign of all terms of a sum or of none, so it changes no rounding. But QR takes the sign of a
/// reflection from an entry of the matrix, and a mirror changes this sign.
TEST(BitForBit, MirrorsExceptByQr) { expect_bit_for_bit({mirror(0), mirror(1), mirror(2)}, "-qr-"); }

/// Powers of two change only exponents, and the square root of an even power is a power of two.
TEST(BitForBit, UnitsOfLengthTimeAndAnEvenPowerOfMass) { expect_bit_for_bit({units_changed_by(4, -3, 1)}); }

/// K scales as 1/mass. Cholesky takes square roots of its pivots, and the rounded √(2x) is not √2 times the rounded √x.
/// The other solves take no square root.
TEST(BitForBit, AnOddPowerOfMassExceptByCholesky) { expect_bit_for_bit({units_changed_by(5, 0, 0)}, "llt"); }

/// The outcome of another collision does not pass as a related one.
TEST(BitForBit, IsNotFoundWhereACollisionIsNotRelated) {
  const Subject subject = subjects::subject_named("frictionless-double").value();
  const Relation wrong{swap().of_collision, [](Outcome<long double> y) { return y; }};
  EXPECT_GT(differences(subject, wrong), 100U);
}

}  // namespace
}  // namespace carom::properties
