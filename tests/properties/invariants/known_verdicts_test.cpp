// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/trial/trial.hpp>

#include "support/known_collisions.hpp"
#include "support/known_values.hpp"

/// The residual of every invariant and its allowance, of a solver that is wrong. As
/// tests/oracles/judge/known_values_test.cpp.
namespace carom::properties {
namespace {

using unit::KnownCollision;
using unit::KnownLine;

/// Adds velocities of no impulse, which depend on the origin, and shows a matrix that is not symmetric.
ExactAnswer wrong_answer(const Collision& c) {
  if (!validate(c).empty()) {
    return Refused{"invalid"};
  }
  const double times = 1 + (c.a.position + 2 * c.point).sum() / (1 + c.point.norm()) + c.a.velocity[0] / 16;
  Outcome<double> outcome = unchanged(c);
  outcome.a.velocity += times * Vector3<double>(5, 16, -3);
  outcome.a.angular_velocity += times * Vector3<double>(2, -7, 1);
  outcome.b.velocity += times * Vector3<double>(-6, -11, 4);
  outcome.b.angular_velocity += times * Vector3<double>(8, 3, -1);
  ReportedOutcome reported = map_outcome<long double>(outcome, [](double x) { return static_cast<long double>(x); });
  Matrix3<long double> matrix;
  matrix << -1, 0.25L, 0.5L, 0.125L, 2, -0.75L, 0.5L, -0.75L, 30;
  reported.collision_matrix = matrix;
  return oracles::LiftedOutcome(reported);
}

TEST(KnownValues, OfTheInvariants) {
  std::vector<KnownLine> lines;
  for (const KnownCollision& known : unit::known_collisions()) {
    const JudgedCase judged_case({known.collision, true});
    for (const Model model : all_models) {
      Claim claim;
      claim.model = model;
      claim.yardstick.unit_roundoff = 0x1p-20;
      for (const Invariant& invariant : all_invariants()) {
        if (invariant.claimed_for(model) && !std::holds_alternative<AboutSession>(invariant.about)) {
          claim.invariants.push_back(&invariant);
        }
      }
      KnownLine line{known.name + ", " + std::string(name_of(model)), {}};
      for (const NamedVerdict& named : try_case(judged_case, claim, wrong_answer).verdicts) {
        const Verdict& verdict = named.verdict;
        line.name += ' ' + std::string(named.invariant->name);
        line.numbers.push_back(verdict.is_undecided ? -1 : static_cast<int>(verdict.status));
        line.numbers.push_back(verdict.residual);
        line.numbers.push_back(verdict.allowed);
        line.numbers.push_back(verdict.relative_residual());
        line.numbers.push_back(seriousness(verdict, known.collision));
      }
      lines.push_back(std::move(line));
    }
  }
  unit::expect_known_lines(CAROM_KNOWN_VALUES, lines);
}

}  // namespace
}  // namespace carom::properties
