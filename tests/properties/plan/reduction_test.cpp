// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <gtest/gtest.h>

#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/properties/plan/reduction.hpp>

#include "support/cases.hpp"

namespace carom::properties::plan {
namespace {

using oracles::ExactCase;
using oracles::Rational;

template <class T>
bool are_same(const Outcome<T>& x, const Outcome<Rational>& y) {
  const auto of_x = vectors(x);
  const auto of_y = vectors(y);
  return std::ranges::all_of(all_outcome_vectors, [&](OutcomeVector k) {
    return (*of_x[k])[0] == T((*of_y[k])[0]) && (*of_x[k])[1] == T((*of_y[k])[1]) && (*of_x[k])[2] == T((*of_y[k])[2]);
  });
}

/// Whether the exact outcomes of two laws are the same. Preconditions: each law has one exact outcome, and the outcome
/// of `lesser` is rational.
bool answer_alike(const ExactCase& c, Law law, Law lesser) {
  return c.with_truth(law, c.state(), [&]<class T>(const oracles::Truth<T>& truth) {
    return are_same<T>(truth.outcome, c.truth(lesser).outcome);
  });
}

/// Cases of every family, and collisions of small dyadic numbers. For many of the latter, two laws have equal outcomes.
std::vector<Collision> cases() {
  std::vector<Collision> all;
  for (const auto& [family, one] : unit::valid_cases(6)) {
    all.push_back(one.collision);
  }
  Stream stream = case_stream(unit::seed, "reduction", 0);
  for (int i = 0; i < 120; ++i) {
    Collision c = unit::small_collision(stream);
    c.friction = stream.integer(0, 3) / 2.0;
    c.tangential_restitution = stream.integer(-1, 1);
    all.push_back(c);
    c.a.position = c.point + c.normal;  // r_A along N
    c.b.position = c.point - c.normal;
    c.a.principal_inertia.setConstant(1);
    c.b.principal_inertia.setConstant(2);
    all.push_back(c);
    c.a.velocity = c.b.velocity - c.normal;  // head-on
    c.a.angular_velocity.setZero();
    c.b.angular_velocity.setZero();
    all.push_back(c);
  }
  return all;
}

/// `reduction` gives a reason if and only if the exact outcomes of two laws are equal.
TEST(Reduction, ToFrictionlessIsGivenIfAndOnlyIfTheExactOutcomesAreTheSame) {
  PerLaw<int> given{};
  PerLaw<int> not_given{};
  for (const Collision& collision : cases()) {
    const ExactCase c(collision);
    if (c.state() != oracles::ContactState::colliding) {
      continue;
    }
    for (const Law law : {Law::reflection, Law::sticking, Law::rough}) {
      const bool is_given = reduction(c, law, Law::frictionless).has_value();
      ++(is_given ? given : not_given)[law];
      EXPECT_EQ(is_given, answer_alike(c, law, Law::frictionless)) << name_of(law);
    }
  }
  for (const Law law : {Law::reflection, Law::sticking, Law::rough}) {
    EXPECT_GT(given[law], 3) << name_of(law);
    EXPECT_GT(not_given[law], 50) << name_of(law);
  }
}

TEST(Reduction, OfRoughToStickingIsGivenOnlyIfTheExactOutcomesAreTheSame) {
  int given = 0;
  for (const Collision& collision : cases()) {
    const ExactCase c(collision);
    if (c.state() == oracles::ContactState::colliding && reduction(c, Law::rough, Law::sticking)) {
      ++given;
      EXPECT_TRUE(answer_alike(c, Law::rough, Law::sticking));
    }
  }
  EXPECT_GT(given, 10);
}

/// A law that replaces `coulomb` gives one of the answers that oracles::coulomb_answers finds independently.
TEST(Reduction, OfCoulombIsGivenOnlyIfTheLesserLawGivesAnAnswer) {
  PerLaw<int> given{};
  const std::vector<Collision> all = cases();
  for (std::size_t i = 0; i < all.size(); i += 4) {  // isolating the answers takes milliseconds
    const ExactCase c(all[i]);
    if (c.state() != oracles::ContactState::colliding) {
      continue;
    }
    const auto answers = oracles::coulomb_answers(c);
    for (const Law lesser : {Law::frictionless, Law::sticking}) {
      if (reduction(c, Law::coulomb, lesser)) {
        ++given[lesser];
        EXPECT_TRUE(std::ranges::any_of(answers, [&](const oracles::CoulombAnswer& answer) {
          return answer.is_exact() && are_same<Rational>(answer.truth.outcome, c.truth(lesser).outcome);
        })) << name_of(lesser);
      }
    }
    if (reduction(c, Law::coulomb, Law::rough)) {
      ++given[Law::rough];
      EXPECT_GT(oracles::nearest_answer(c, answers, reported(c.nearest_truth(Law::rough))).digits, 10);
    }
  }
  EXPECT_GT(given[Law::frictionless], 3);
  EXPECT_GT(given[Law::sticking], 10);
  EXPECT_GT(given[Law::rough], 3);
}

TEST(Reduction, OfSpheresIsByTheEigenvectorWhateverTheirVelocities) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    Collision spheres = unit::case_of("collinear_spheres", i).collision;
    EXPECT_EQ(reduction(ExactCase(spheres), Law::reflection, Law::frictionless), Reduction::eigenvector);
    spheres.a.angular_velocity = {3, -2, 1};
    EXPECT_TRUE(is_normal_eigenvector(ExactCase(spheres)));
    spheres.a.position[static_cast<int>(i % 3)] += 0.25;  // the lever arm leaves the normal
    const ExactCase moved(spheres);
    if (moved.state() == oracles::ContactState::colliding) {
      EXPECT_EQ(is_normal_eigenvector(moved), answer_alike(moved, Law::reflection, Law::frictionless));
    }
  }
}

TEST(Reduction, IsGivenForEveryLesserLawIfNothingCollides) {
  Collision c = unit::ball_on_a_plane(0.5, 1);
  c.a.velocity = {1, 2, 0};
  for (const Law law : all_laws) {
    for (const Law lesser : lesser_laws(law)) {
      EXPECT_EQ(reduction(ExactCase(c), law, lesser), law == lesser ? Reduction::same_law : Reduction::untouched);
    }
  }
}

TEST(LesserLaws, EndWithTheLawItself) {
  for (const Law law : all_laws) {
    if (law == Law::any) {
      EXPECT_TRUE(lesser_laws(law).empty());
    } else {
      EXPECT_EQ(lesser_laws(law).back(), law);
    }
  }
}

}  // namespace
}  // namespace carom::properties::plan
