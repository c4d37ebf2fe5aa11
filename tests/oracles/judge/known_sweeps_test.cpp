// SPDX-License-Identifier: BSL-1.0
#include "support/known_sweeps.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/filters/stage.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/models/sensitivity.hpp>

#include "support/known_values.hpp"
#include "support/outcome_of_law.hpp"

/// Each recorded line counts, for one sweep, the collisions on which each filter decides, and the collisions on which
/// each fact holds. A filter that decides less changes no verdict, but slows the judge.
namespace carom::oracles {
namespace {

using unit::KnownLine;
using unit::Sweep;

constexpr double allowance_of_sweeps = 0x1p-40;

Yardstick yardstick_of_sweeps() {
  Yardstick yardstick;
  yardstick.unit_roundoff = allowance_of_sweeps / default_limit_ulps;
  return yardstick;
}

std::vector<std::pair<std::string_view, bool>> facts_of(const ExactCase& exact_case) {
  const BoundedCase& bounds = exact_case.bounds();
  std::vector<std::pair<std::string_view, bool>> facts{
      {"normal_velocity", bounds.normal_velocity().has_value()},
      {"is_inside_cone", bounds.is_inside_cone().has_value()},
      {"reaches_cone", bounds.reaches_cone().has_value()},
      {"is_moderate", bounds.is_moderate()},
      {"is_well_conditioned", bounds.is_well_conditioned()},
      {"has_clear_divisor", bounds.is_moderate() && bounds.has_clear_divisor()},
      {"colliding", exact_case.approach() == Approach::colliding},
      {"separating", exact_case.approach() == Approach::separating},
      {"is_grazing", exact_case.is_grazing(allowance_of_sweeps)},
      {"permitted_inputs", exact_case.permitted_inputs(allowance_of_sweeps) != nullptr},
      {"is_bounded_by_64", exact_case.is_bounded_by(Rational(64))},
      {"is_collinear", exact_case.is_collinear()},
      {"is_head_on", exact_case.is_head_on()}};
  for (const Law law : laws_with_truth) {
    facts.emplace_back("is_moderate for a law", exact_case.is_moderate(law));
    facts.emplace_back("has_two_answers", exact_case.has_two_answers(law, allowance_of_sweeps));
    facts.emplace_back("is_open", exact_case.is_open(law, allowance_of_sweeps));
  }
  return facts;
}

/// Counts the collisions whose sensitivity binary64 gives, and those whose sensitivity double-double arithmetic gives.
/// Adds up the logarithms of the latter sensitivities. In binary64, rounding spoils the sensitivities of
/// ill-conditioned collisions.
KnownLine line_of_sensitivities(const Sweep& sweep, Law law) {
  KnownLine line{sweep.name + ", sensitivities of " + std::string(name_of(law)), {0, 0, 0}};
  for (int k = 0; k < sweep.count; k += 4) {
    const Collision c = sweep.collision(k);
    const ExactCase exact_case(c);
    const Branch branch = exact_case.branch(law);
    line.numbers[0] += colliding_sensitivity(c, law, branch) ? 1 : 0;
    if (const auto enclosed = enclosed_sensitivity(c, law, branch, exact_case.is_moderate())) {
      line.numbers[1] += 1;
      for (const double one : *enclosed) {
        line.numbers[2] += std::log2(1 + one);
      }
    }
  }
  return line;
}

KnownLine line_of_facts(const Sweep& sweep) {
  KnownLine line{sweep.name, {}};
  for (int k = 0; k < sweep.count; ++k) {
    std::size_t next = 0;
    for (const auto& [name, holds] : facts_of(ExactCase(sweep.collision(k)))) {
      if (k == 0) {
        line.name += ' ' + std::string(name);
        line.numbers.push_back(0);
      }
      line.numbers[next++] += holds ? 1 : 0;
    }
  }
  return line;
}

/// Adds errors of 2⁻ʲ to the truth. Counts how often the judge allows the sum, and the decisions of each stage.
KnownLine line_of_stages(const Sweep& sweep, Law law) {
  double allowed = 0;
  const StageCounts before = decided_by_stage();
  for (int k = 0; k < sweep.count; k += 9) {
    const ExactCase exact_case(sweep.collision(k));
    for (int j = 30; j < 50; ++j) {
      ReportedOutcome outcome = unit::reported_outcome(exact_case, law);
      for (Vector3<long double>* vector : vectors(outcome)) {
        *vector += Vector3<long double>(std::ldexp(1.0L, -j), 0, -std::ldexp(3.0L, -j));
      }
      const Accuracy result =
          accuracy(exact_case, law, LiftedOutcome(outcome), yardstick_of_sweeps(), default_limit_ulps / 2);
      allowed += result.is_allowed() ? 1 : 0;
    }
  }
  KnownLine line{sweep.name + ", stages of " + std::string(name_of(law)), {allowed}};
  for (const Stage stage : all_stages) {
    line.numbers.push_back(static_cast<double>(decided_by_stage()[stage] - before[stage]));
  }
  return line;
}

TEST(KnownValues, OfSweeps) {
  std::vector<KnownLine> lines;
  for (const Sweep& sweep : unit::sweeps()) {
    for (int k = 0; k < sweep.count; ++k) {
      ASSERT_TRUE(validate(sweep.collision(k)).empty()) << sweep.name << ' ' << k;
    }
    lines.push_back(line_of_facts(sweep));
    for (const Law law : laws_with_truth) {
      lines.push_back(line_of_sensitivities(sweep, law));
      lines.push_back(line_of_stages(sweep, law));
    }
  }
  unit::expect_known_lines(CAROM_KNOWN_SWEEPS, lines);
}

}  // namespace
}  // namespace carom::oracles
