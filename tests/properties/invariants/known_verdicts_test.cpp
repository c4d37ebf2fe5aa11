// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/filters/stage.hpp>
#include <carom/properties/trial/trial.hpp>

#include "support/known_collisions.hpp"
#include "support/known_sweeps.hpp"
#include "support/known_values.hpp"
#include "support/outcome_of_law.hpp"

/// Compares the residual and the permitted residual of every invariant, for a wrong solver, with recorded numbers.
/// tests/oracles/judge/known_values_test.cpp gives the reason.
namespace carom::properties {
namespace {

using unit::KnownCollision;
using unit::KnownLine;

/// Adds velocities that no impulse gives and that depend on the origin. Reports a matrix that is not symmetric.
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
  ReportedOutcome reported = carom::reported(outcome);
  Matrix3<long double> matrix;
  matrix << -1, 0.25L, 0.5L, 0.125L, 2, -0.75L, 0.5L, -0.75L, 30;
  reported.collision_matrix = matrix;
  return oracles::LiftedOutcome(reported);
}

/// All invariants that a law can claim, except those about sessions.
Claim whole_claim(Law law, double unit_roundoff) {
  Claim claim;
  claim.law = law;
  claim.yardstick.unit_roundoff = unit_roundoff;
  for (const Invariant& invariant : all_invariants()) {
    if (invariant.claimed_for(law) && !std::holds_alternative<AboutSession>(invariant.about)) {
      claim.invariants.push_back(&invariant);
    }
  }
  return claim;
}

TEST(KnownValues, OfTheInvariants) {
  std::vector<KnownLine> lines;
  for (const KnownCollision& known : unit::known_collisions()) {
    const JudgedCase judged_case({known.collision, true});
    for (const Law law : all_laws) {
      const Claim claim = whole_claim(law, 0x1p-20);
      KnownLine line{known.name + ", " + std::string(name_of(law)), {}};
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

/// A hash of the bits of all numbers, below 10⁴, so that lines with five digits tell all values apart. Zeros of both
/// signs count as one number.
double hash_of(const Collision& collision) {
  std::uint64_t hash = 0;
  for_each_number(
      [&](const FieldPath&, const double& number) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(number + 0.0)) * 0x100000001b3U;
        hash ^= hash >> 32U;
      },
      collision);
  return static_cast<double>(hash % 10000);
}

/// The related collisions belong to the seeds that reports give, so they are the same in the next release.
TEST(KnownValues, OfTheRelatedCollisions) {
  std::vector<KnownLine> lines;
  for (const KnownCollision& known : unit::known_collisions()) {
    const Outcome<double> outcome = oracles::ExactCase(known.collision).nearest_truth(Law::reflection);
    KnownLine line{known.name, {}};
    for (const Invariant& invariant : all_invariants()) {
      if (const auto* relation = std::get_if<AboutRelation>(&invariant.about)) {
        line.name += ' ' + std::string(invariant.name);
        const auto* of_collision = std::get_if<AboutRelation::OfCollision>(&relation->ask);
        for (const Collision& related :
             of_collision != nullptr ? (*of_collision)(known.collision)
                                     : std::get<AboutRelation::OfOutcome>(relation->ask)(known.collision, outcome)) {
          line.numbers.push_back(hash_of(related));
        }
      }
    }
    lines.push_back(std::move(line));
  }
  unit::expect_known_lines(CAROM_KNOWN_RELATED, lines);
}

ExactAnswer right_answer(const Collision& c, Law law) {
  if (!validate(c).empty()) {
    return Refused{"invalid"};
  }
  return oracles::LiftedOutcome(unit::reported_outcome_with_matrix(oracles::ExactCase(c), law));
}

/// Adds 2⁻¹⁰ times velocities that no impulse gives, and 2⁻¹⁰ to each entry of the matrix.
ExactAnswer nearly_right_answer(const Collision& c, Law law) {
  ExactAnswer answer = right_answer(c, law);
  if (const auto* right = std::get_if<oracles::LiftedOutcome>(&answer)) {
    ReportedOutcome reported{*right->reported()};
    const std::array<Vector3<long double>, 4> by{Vector3<long double>{5, 16, -3}, {2, -7, 1}, {-6, -11, 4}, {8, 3, -1}};
    for (const OutcomeVector k : all_outcome_vectors) {
      *vectors(reported)[k] += 0x1p-10L * by[static_cast<std::size_t>(k)];
    }
    reported.collision_matrix = *right->collision_matrix()->reported() + 0x1p-10L * Matrix3<long double>::Ones();
    return oracles::LiftedOutcome(reported);
  }
  return answer;
}

void append_stages_since(const oracles::StageCounts& before, KnownLine& line) {
  for (const oracles::Stage stage : oracles::all_stages) {
    line.numbers.push_back(static_cast<double>(oracles::decided_by_stage()[stage] - before[stage]));
  }
}

using StatusCounts = std::map<std::string_view, std::map<Status, int>>;

void append_counts(StatusCounts& counts, KnownLine& line) {
  for (auto& [name, of_status] : counts) {
    line.name += ' ' + std::string(name);
    for (const Status status : {Status::holds, Status::violated, Status::skipped}) {
      line.numbers.push_back(of_status[status]);
    }
  }
}

/// For each invariant, counts the allowances at which it has each status. Also counts the decisions of each filter. If
/// a limit moves by a factor of √2, a count changes.
TEST(KnownValues, OfTheAllowancesAtWhichVerdictsChange) {
  std::vector<KnownLine> lines;
  for (const KnownCollision& known : unit::known_collisions()) {
    if (known.name != "plain" && known.name != "spins_about_normal") {
      continue;
    }
    const JudgedCase judged_case({known.collision, true});
    StatusCounts counts;
    const oracles::StageCounts before = oracles::decided_by_stage();
    for (int i = 2; i < 34; ++i) {
      const Claim claim = whole_claim(Law::rough, std::exp2(-i / 2.0) / oracles::default_limit_ulps);
      const auto solve = [&](const Collision& c) { return nearly_right_answer(c, Law::rough); };
      for (const NamedVerdict& named : try_case(judged_case, claim, solve).verdicts) {
        ++counts[named.invariant->name][named.verdict.status];
      }
    }
    KnownLine line{known.name, {}};
    append_counts(counts, line);
    append_stages_since(before, line);
    lines.push_back(std::move(line));
  }
  unit::expect_known_lines(CAROM_KNOWN_ALLOWANCES, lines);
}

bool is_judged_or_unjudged(const Judgement& judgement) {
  return judgement.unjudged.has_value() != !judgement.verdicts.empty();
}

/// Counts the decisions of each filter. A filter that decides less changes no verdict, but slows the judge.
TEST(KnownValues, OfTheStagesThatDecide) {
  std::vector<KnownLine> lines;
  for (const KnownCollision& known : unit::known_collisions()) {
    const JudgedCase judged_case({known.collision, true});
    for (const Law law : laws_with_truth) {
      for (const Precision precision : {Precision::binary32, Precision::binary64}) {
        const oracles::StageCounts before = oracles::decided_by_stage();
        const Claim claim = whole_claim(law, unit_roundoff(precision));
        const auto solve = [&](const Collision& c) { return right_answer(c, law); };
        const Judgement judgement = try_case(judged_case, claim, solve);
        EXPECT_TRUE(is_judged_or_unjudged(judgement)) << known.name;
        KnownLine line{known.name + ", " + std::string(name_of(law)) + ", " + std::string(name_of(precision)), {}};
        append_stages_since(before, line);
        lines.push_back(std::move(line));
      }
    }
  }
  unit::expect_known_lines(CAROM_KNOWN_STAGES, lines);
}

TEST(KnownValues, OfVerdictsInSweeps) {
  std::vector<KnownLine> lines;
  for (const unit::Sweep& sweep : unit::sweeps()) {
    for (const Law law : {Law::rough, Law::reflection}) {
      KnownLine line{sweep.name + ", " + std::string(name_of(law)), {}};
      StatusCounts counts;
      const oracles::StageCounts before = oracles::decided_by_stage();
      for (int k = 0; k < sweep.count; k += 24) {
        const JudgedCase judged_case({sweep.collision(k), true});
        ASSERT_TRUE(judged_case.is_valid()) << sweep.name << ' ' << k;
        const auto solve = [&](const Collision& c) { return right_answer(c, law); };
        for (const NamedVerdict& named : try_case(judged_case, whole_claim(law, 0x1p-53), solve).verdicts) {
          ++counts[named.invariant->name][named.verdict.status];
        }
      }
      append_counts(counts, line);
      append_stages_since(before, line);
      lines.push_back(std::move(line));
    }
  }
  unit::expect_known_lines(CAROM_KNOWN_VERDICTS_IN_SWEEPS, lines);
}

TEST(Stages, AreRationalAloneWithoutFilters) {
  const oracles::StageCounts before = oracles::decided_by_stage();
  for (const KnownCollision& known : unit::known_collisions()) {
    const JudgedCase judged_case({known.collision, true}, false);
    Claim claim = whole_claim(Law::reflection, 0x1p-24);
    std::erase_if(claim.invariants, [](const Invariant* invariant) { return invariant->asks(); });
    claim.yardstick.filtered = false;
    EXPECT_TRUE(is_judged_or_unjudged(try_case(judged_case, claim, wrong_answer))) << known.name;
  }
  for (const oracles::Stage stage : oracles::all_stages) {
    const std::uint64_t count = oracles::decided_by_stage()[stage] - before[stage];
    EXPECT_EQ(count > 0, stage == oracles::Stage::rational) << static_cast<int>(stage);
  }
}

}  // namespace
}  // namespace carom::properties
