// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/oracles/filters/stage.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>

namespace carom::properties {
namespace {

struct JudgedRun {
  GateReport report;
  oracles::StageCounts decided;
};

JudgedRun run_of(bool filtered) {
  GateOptions options;
  options.cases = 8;
  options.limits.filtered = filtered;
  for (const Family& family : all_families()) {
    options.families.push_back(&family);
  }
  const oracles::StageCounts before = oracles::decided_by_stage();
  JudgedRun run{run_gate({*subjects::subject_named("frictionless-double"), *subjects::subject_named("reflection-float"),
                          *subjects::subject_named("reflection-in-basis-double")},
                         options),
                oracles::decided_by_stage()};
  for (const oracles::Stage stage : oracles::all_stages) {
    run.decided[stage] -= before[stage];
  }
  return run;
}

TEST(UnfilteredGate, DecidesAllByRationalsAndAsTheFilterDoes) {
  const JudgedRun filtered = run_of(true);
  const JudgedRun exact = run_of(false);
  for (const oracles::Stage stage : oracles::all_stages) {
    EXPECT_EQ(exact.decided[stage] > 0, stage == oracles::Stage::rational) << static_cast<int>(stage);
    EXPECT_GT(filtered.decided[stage], 0U) << static_cast<int>(stage);
  }
  std::uint64_t violated = 0;
  ASSERT_EQ(filtered.report.results.size(), exact.report.results.size());
  for (std::size_t s = 0; s < exact.report.results.size(); ++s) {
    for (std::size_t f = 0; f < exact.report.options.families.size(); ++f) {
      const FamilyResult& by_filter = filtered.report.results[s].families[f];
      const FamilyResult& by_rationals = exact.report.results[s].families[f];
      ASSERT_EQ(by_filter.counts.size(), by_rationals.counts.size());
      for (const auto& [invariant, count] : by_rationals.counts) {
        const Count& other = by_filter.counts.at(invariant);
        EXPECT_EQ(count.holds, other.holds) << invariant;
        EXPECT_EQ(count.violated, other.violated) << invariant;
        EXPECT_EQ(count.skipped, other.skipped) << invariant;
        violated += count.violated;
      }
    }
  }
  EXPECT_GT(violated, 0U);
}

TEST(UnfilteredGate, KnowsTheSameOfACollision) {
  for (const Family& family : all_families()) {
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Case one = drawn_case(family, 3, i);
      const JudgedCase filtered(one);
      const JudgedCase exact(one, false);
      ASSERT_EQ(filtered.is_valid(), exact.is_valid());
      if (exact.is_valid()) {
        EXPECT_EQ(filtered.exact().approach(), exact.exact().approach()) << family.name << ' ' << i;
        EXPECT_EQ(filtered.exact().is_collinear(), exact.exact().is_collinear()) << family.name << ' ' << i;
        EXPECT_EQ(filtered.exact().is_head_on(), exact.exact().is_head_on()) << family.name << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace carom::properties
