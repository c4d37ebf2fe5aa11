// SPDX-License-Identifier: BSL-1.0
#include <set>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/stage.hpp>
#include <carom/properties/gate/trial.hpp>

#include "support/cases.hpp"
#include "support/known_collisions.hpp"

/// The verdicts that users see on a few collisions, and why.
namespace carom::properties {
namespace {

using Names = std::set<std::string_view>;

/// All invariants that a law can claim about one answer, with its matrix.
Claim whole_claim(Law law, Precision precision) {
  Subject subject;
  subject.law = law;
  subject.precision = precision;
  subject.shows_collision_matrix = true;
  Claim claim = claim_of(subject, {});
  std::erase_if(claim.invariants, [](const Invariant* invariant) { return !invariant->is_of_one_answer(); });
  return claim;
}

ReportedOutcome right_answer(const Collision& c, Law law) {
  return unit::reported_outcome_with_matrix(oracles::ExactCase(c), law);
}

Judgement judged(const Collision& collision, Law law, Precision precision, const ReportedOutcome& answer) {
  return try_case(JudgedCase({collision}), whole_claim(law, precision),
                  [&](const Collision&) -> ExactAnswer { return oracles::LiftedOutcome(answer); });
}

Names violated_in(const Judgement& judgement) {
  Names names;
  for (const NamedVerdict& named : judgement.verdicts) {
    if (named.verdict.status == Status::violated) {
      names.insert(named.invariant->name);
    }
  }
  return names;
}

/// Expects the violations if a solver of the law `solved` reads the changed collision.
void expect_violated(const Names& expected, const Collision& collision, Law claimed, Law solved,
                     void (*misread)(Collision&)) {
  Collision read = collision;
  misread(read);
  EXPECT_EQ(violated_in(judged(collision, claimed, Precision::binary64, right_answer(read, solved))), expected)
      << name_of(claimed) << ' ' << name_of(solved);
}

TEST(KnownCollisions, ShowWhichInvariantsAWrongAnswerViolates) {
  using enum Law;
  // The lever arm is along the normal, so K N = λ N: frictionless, reflection and the bound of the impulse agree.
  Collision ball = unit::ball_on_a_plane(0.5, 0.125);
  ball.tangential_restitution = 0.5;
  const auto of_ball = [&](Law law, void (*misread)(Collision&), const Names& expected) {
    expect_violated(expected, ball, law, law, misread);
  };
  of_ball(frictionless, [](Collision& c) { c.restitution = 0; }, {"backward_error", "restitution"});
  // With a larger ε, the impulse exceeds its bound. With four times the speed, the ball also gains energy.
  of_ball(reflection, [](Collision& c) { c.restitution = 1; }, {"backward_error", "impulse_bound", "restitution"});
  of_ball(frictionless, [](Collision& c) { c.a.velocity[1] *= 4; },
          {"backward_error", "energy", "impulse_bound", "parting_speed", "restitution"});
  // With the wrong side of the normal, the ball flies on into the plane.
  of_ball(sticking, [](Collision& c) { c.normal *= -1; },
          {"backward_error", "non_penetration", "restitution", "sticks"});
  // An immovable B moves. The matrix has B's share, too.
  of_ball(sticking, [](Collision& c) { c.b.immovable = false; },
          {"backward_error", "immovable_untouched", "matrix_used"});
  // Only a tangential impulse turns the ball, and so depends on its moments. The matrix always depends on them.
  of_ball(reflection, [](Collision& c) { c.a.principal_inertia *= 2; }, {"matrix_used"});
  of_ball(coulomb, [](Collision& c) { c.a.principal_inertia *= 2; }, {"angular_momentum", "matrix_used"});
  // With too much friction the ball sticks. With none, it slips without friction.
  of_ball(coulomb, [](Collision& c) { c.friction = 2; }, {"friction_cone"});
  of_ball(coulomb, [](Collision& c) { c.friction = 0; }, {"slip_opposed"});
  // With e_t = −1, `rough` has no friction. `coulomb` does not read e_t.
  of_ball(rough, [](Collision& c) { c.tangential_restitution = -1; }, {"backward_error"});
  of_ball(coulomb, [](Collision& c) { c.tangential_restitution = -1; }, {});

  // A parting ball is pulled back.
  Collision parting = ball;
  parting.normal *= -1;
  expect_violated({"backward_error", "friction_cone", "non_penetration", "push", "separating_untouched"}, parting,
                  rough, rough, [](Collision& c) { c.normal *= -1; });
  // A rebounds as if B were a wall, so B lacks its momentum. The impulse is too large, and the matrix too small.
  const Collision plain = unit::plain_collision();
  expect_violated({"angular_momentum", "backward_error", "definite", "impulse_bound", "linear_momentum", "matrix_used"},
                  plain, frictionless, frictionless, [](Collision& c) { c.b.immovable = true; });

  // Other laws' answers conserve momentum and obey restitution. They violate the equation of the claimed law.
  const auto other_law = [](const Collision& c, Law claimed, Law solved, const Names& expected) {
    expect_violated(expected, c, claimed, solved, [](Collision&) {});
  };
  other_law(plain, frictionless, reflection, {"backward_error", "frictionless_direction"});
  other_law(plain, reflection, frictionless, {"backward_error", "reflection_plane"});
  other_law(plain, sticking, frictionless, {"backward_error", "sticks"});
  other_law(ball, frictionless, sticking,
            {"backward_error", "collinear_spin", "frictionless_direction", "impulse_bound"});
}

/// The ball slips along a plane, and parts faster than before by 4 α, with the allowance α. If it does not collide, α
/// times the scale is 3 α: 1 for v⁻ and 2 for v⁺. If it collides, V⁺ + V⁻ adds 2 for N. So rounding explains the speed
/// only if the ball may collide, that is, if N·V⁻ is a rounding error.
TEST(KnownCollisions, MayPartByTheRoundingOfEitherApproach) {
  constexpr double allowance = 0x1p-48;
  for (const double parting : {0x1p-60, 0x1p-20}) {
    Collision c;
    c.normal = {0x1p-10, 1, 0};
    c.a.velocity = {1, -0x1p-10 + parting, 0};
    c.b.immovable = true;
    ReportedOutcome answer = reported(unchanged(c));
    answer.a.velocity[1] += 4 * allowance;
    const Names violated = violated_in(judged(c, Law::any, Precision::binary64, answer));
    EXPECT_EQ(violated.contains("parting_speed"), parting == 0x1p-20) << parting;
  }
}

/// Rational arithmetic is slow, so filters decide every comparison of moderate collisions.
TEST(KnownCollisions, HaveRightAnswersThatHoldByFilters) {
  for (const unit::KnownCollision& known : unit::known_collisions()) {
    const bool is_moderate = oracles::ExactCase(known.collision).is_moderate();
    EXPECT_EQ(is_moderate, known.name != "huge");
    for (const Law law : laws_with_truth) {
      for (const Precision precision : {Precision::binary32, Precision::binary64}) {
        const std::uint64_t before = oracles::decided_by_stage()[oracles::Stage::rational];
        const Judgement judgement = judged(known.collision, law, precision, right_answer(known.collision, law));
        EXPECT_EQ(violated_in(judgement), Names{}) << known.name << ", " << name_of(law);
        EXPECT_EQ(judgement.verdicts.empty(), judgement.unjudged.has_value()) << known.name;
        EXPECT_EQ(judgement.unjudged.has_value(), !is_moderate && precision == Precision::binary32) << known.name;
        if (is_moderate) {
          EXPECT_EQ(oracles::decided_by_stage()[oracles::Stage::rational], before) << known.name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom::properties
