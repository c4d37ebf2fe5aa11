// SPDX-License-Identifier: BSL-1.0
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/sticking.hpp>

#include "support/exact.hpp"

/// The solvers in ℚ satisfy every invariant of their law with the allowance 0.
namespace carom::properties {
namespace {

using oracles::Rational;
using Contact = impulse::Contact<Rational>;

struct ExactSolver {
  std::string name;
  Subject subject;  // its claim
  ExactSolve solve;
};

/// `solve` takes a contact and a function that receives the collision matrix. `solve` returns an outcome.
template <class Solve>
ExactSolver exactly(const std::string& name, Law law, Solve solve) {
  Subject subject;
  subject.law = law;
  subject.shows_collision_matrix = law != Law::frictionless;
  return {name, subject, [solve](const Collision& collision) -> ExactAnswer {
            if (!validate(collision).empty()) {
              return Refused{"invalid"};
            }
            std::optional<Matrix3<Rational>> seen;
            const Outcome<Rational> outcome = solve(impulse::make_contact<Rational>(oracles::lift(collision)),
                                                    [&](const Matrix3<Rational>& matrix) { seen = matrix; });
            return oracles::LiftedOutcome(SolvedOutcome<Rational>(outcome, seen));
          }};
}

template <class Solve>
ExactSolver reflection_exactly(const std::string& name) {
  return exactly(name, Law::reflection, [](const Contact& contact, const auto& see) {
    return apply_impulse(contact, impulse::reflection_impulse<Solve>(contact, normal_velocity(contact), see));
  });
}

std::vector<ExactSolver> exact_solvers() {
  return {exactly("frictionless", Law::frictionless,
                  [](const Contact& contact, const auto& /*see*/) { return impulse::frictionless(contact); }),
          exactly("sticking", Law::sticking,
                  [](const Contact& contact, const auto& see) {
                    return apply_impulse(contact, impulse::sticking_impulse(contact, normal_velocity(contact), see));
                  }),
          reflection_exactly<impulse::Ldlt>("reflection by LDLᵀ"),
          reflection_exactly<impulse::Adjugate>("reflection by the adjugate")};
}

/// Whether all velocities after the impulse are those before it.
bool is_unchanged(const ExactAnswer& answer, const JudgedCase& one) {
  const auto* outcome = std::get_if<oracles::LiftedOutcome>(&answer);
  return outcome == nullptr || !one.is_valid() || unit::same(outcome->exact(), unchanged(one.exact().exact()));
}

TEST(ExactSolvers, SatisfyEachClaimedInvariantWithoutAnAllowance) {
  for (const ExactSolver& solver : exact_solvers()) {
    Claim claim = claim_of(solver.subject, {});
    claim.yardstick = oracles::Yardstick::of_exact_arithmetic();
    std::erase_if(claim.invariants, [](const Invariant* one) { return one->is_of_session(); });
    std::set<const Invariant*> held;
    int responses = 0;
    for (const Family& family : all_families()) {
      for (std::uint64_t i = 0; i < 8; ++i) {
        const JudgedCase one(unit::case_of(family.name, i));
        const Judgement judgement = try_case(one, claim, solver.solve);
        EXPECT_FALSE(judgement.skipped) << solver.name << ", " << family.name << ' ' << i;
        for (const auto& [invariant, verdict] : judgement.verdicts) {
          EXPECT_NE(verdict.status, Status::violated)
              << solver.name << ", " << family.name << ' ' << i << ", " << invariant->name << ": " << verdict.detail;
          if (verdict.status == Status::holds) {
            held.insert(invariant);
          }
        }
        responses += is_unchanged(solver.solve(one.generated().collision), one) ? 0 : 1;
      }
    }
    EXPECT_GT(responses, 100) << solver.name;
    for (const Invariant* invariant : claim.invariants) {
      EXPECT_TRUE(held.contains(invariant)) << solver.name << " never tests " << invariant->name;
    }
  }
}

}  // namespace
}  // namespace carom::properties
