// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/suggested_effects.hpp>
#include <carom/properties/gate/ways_on.hpp>

#include "io/threads.hpp"
#include "support/cases.hpp"
#include "support/changed_subject.hpp"

namespace carom::properties {
namespace {

GateReport report_on(const Subject& subject, std::uint64_t cases) {
  GateOptions options = unit::gate_options(cases);
  options.workers = tool::threads(2);
  options.shrinks = false;
  return run_gate({subject}, options);
}

std::vector<WayOn> ways_on(const Subject& subject, std::uint64_t cases) {
  GateReport report = report_on(subject, cases);
  EXPECT_FALSE(report.results.at(0).violated_invariants().empty()) << subject.name;
  add_ways_on(report, {true});
  return report.results.at(0).ways_on;
}

TEST(WaysOn, AreADomainOfASolverThatFailsOnSlenderBodies) {
  const std::vector<WayOn> ways = ways_on(unit::subject_of("frictionless-world-double"), 100);
  ASSERT_EQ(ways.size(), 1U);
  ASSERT_TRUE(ways[0].within);
  const Range& range = ways[0].within->ranges[LimitedQuantity::moment_ratio];
  EXPECT_GT(range.most, 100) << to_text(*ways[0].within);
  EXPECT_LT(range.most, 1e5) << to_text(*ways[0].within);
  Domain alone;
  alone.ranges[LimitedQuantity::moment_ratio] = range;
  EXPECT_EQ(to_text(*ways[0].within), to_text(alone));
  EXPECT_GT(ways[0].cases, 1000U);
}

TEST(WaysOn, AreAThresholdToDeclare) {
  const Subject subject = unit::misreading(unit::subject_of("frictionless-double"), [](Collision& c) {
    const double approach = -dot(c.normal, relative_velocity(c)) / length(c.normal);
    c.restitution = validate(c).empty() && approach < 0.5 ? 0 : c.restitution;
  });
  const std::vector<WayOn> ways = ways_on(subject, 100);
  ASSERT_FALSE(ways.empty());
  EXPECT_FALSE(ways[0].within);
  EXPECT_EQ(to_text(ways[0].effects), "restitution_threshold 0.5 m/s");
}

/// Does nothing if one body is immovable.
Subject idle_at_walls() {
  return unit::with_outcomes(unit::subject_of("frictionless-double"),
                             [](const Collision& collision, ReportedOutcome& outcome) {
                               if (collision.a.immovable != collision.b.immovable) {
                                 outcome = reported(unchanged(collision));
                               }
                             });
}

TEST(WaysOn, AreAKind) {
  const std::vector<WayOn> ways = ways_on(idle_at_walls(), 60);
  ASSERT_EQ(ways.size(), 1U);
  ASSERT_TRUE(ways[0].within);
  EXPECT_EQ(to_text(*ways[0].within), "movable=both");
}

TEST(WaysOn, AreNoneForADefectEverywhere) {
  EXPECT_TRUE(ways_on(unit::idle_subject(), 20).empty());
  const Subject strong = unit::with_outcomes(
      unit::subject_of("frictionless-double"), [](const Collision& collision, ReportedOutcome& outcome) {
        const Outcome<double> before = unchanged(collision);
        for (const OutcomeVector k : all_outcome_vectors) {
          *vectors(outcome)[k] += 0.01L * (*vectors(outcome)[k] - vectors(before)[k]->cast<long double>());
        }
      });
  EXPECT_TRUE(ways_on(strong, 20).empty());
}

TEST(WaysOn, AreNotSoughtAfterTheFirstViolation) {
  GateReport report = report_on(idle_at_walls(), 60);
  report.options.fail_fast = true;
  add_ways_on(report, {true});
  EXPECT_TRUE(report.results.at(0).ways_on.empty());
}

}  // namespace
}  // namespace carom::properties
