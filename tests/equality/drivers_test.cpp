// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/properties/kit/examination.hpp>
#include <carom/properties/plan/certificate.hpp>
#include <carom/properties/scenes/judged_impulses.hpp>
#include <carom/properties/three_properties.hpp>

#include "hard_to_judge.hpp"
#include "support/changed_subject.hpp"

/// The gate, the kit, the three properties, plans and scenes give the verdicts of `judge_in_session`, by which a replay
/// judges. The answers are planted near the limit (hard_to_judge.hpp).
namespace carom::equality {
namespace {

using properties::Case;
using properties::Claim;
using properties::Family;
using properties::Invariant;
using properties::Judgement;
using properties::NamedVerdict;
using properties::Status;

constexpr std::uint64_t seed_of_drivers = 20261128;
constexpr std::uint64_t cases_of_drivers = 2;  // of each family, times its weight

properties::GateOptions options_of_drivers() {
  properties::GateOptions options = unit::gate_options(
      cases_of_drivers, {"generic", "near_special", "grazing", "resting", "immovable_a", "slow", "on_the_cone"});
  options.seed = seed_of_drivers;
  options.shrinks = false;
  options.relations_every = 1;  // a replay judges all of them
  return options;
}

template <class Visit>
void for_each_case(const Visit& visit) {
  for (const Family* family : options_of_drivers().families) {
    for (std::uint64_t index = 0; index < cases_of_drivers * static_cast<std::uint64_t>(family->weight); ++index) {
      visit(*family, properties::drawn_case(*family, seed_of_drivers, index));
    }
  }
}

Judgement replayed(const Claim& claim, const Subject& subject, const Case& one) {
  Session session = subject.open();
  return judge_in_session(claim, session, one).judgement;
}

std::map<const Invariant*, Status> statuses_of(const Judgement& judgement) {
  std::map<const Invariant*, Status> statuses;
  for (const NamedVerdict& named : judgement.verdicts) {
    statuses[named.invariant] = named.verdict.status;
  }
  return statuses;
}

bool is_violated(const Judgement& judgement) {
  return std::ranges::any_of(judgement.verdicts,
                             [](const NamedVerdict& named) { return named.verdict.status == Status::violated; });
}

Claim without_relations(Claim claim) {
  std::erase_if(claim.invariants, [](const Invariant* invariant) { return invariant->asks(); });
  return claim;
}

ReportedOutcome answer_of(const Subject& subject, const Collision& collision) {
  Session session = subject.open();
  return std::get<ReportedOutcome>(properties::answers_of(session, std::span(&collision, 1)).front());
}

class Drivers : public testing::TestWithParam<Precision> {
 protected:
  /// Visits a planting subject of each law, and its claim.
  template <class Visit>
  void for_each_subject(const Visit& visit) const {
    for (const Law law : {Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb}) {
      const Subject subject = planting_subject(law, GetParam());
      visit(subject, properties::claim_of(subject, {}));
    }
  }
};

TEST_P(Drivers, TheGateCountsTheVerdictsOfReplays) {
  for_each_subject([&](const Subject& subject, const Claim& claim) {
    std::map<const Invariant*, properties::Count> expected;
    for_each_case([&](const Family&, const Case& one) {
      for (const auto& [invariant, status] : statuses_of(replayed(claim, subject, one))) {
        properties::Count& count = expected[invariant];
        ++(status == Status::holds ? count.holds : status == Status::violated ? count.violated : count.skipped);
      }
    });
    const properties::SubjectResult result = run_gate({subject}, options_of_drivers()).results.at(0);
    std::uint64_t violated = 0;
    for (const auto& [invariant, count] : expected) {
      const properties::Count found = result.count(*invariant);
      EXPECT_EQ(found.holds, count.holds) << subject.name << ' ' << invariant->name;
      EXPECT_EQ(found.violated, count.violated) << subject.name << ' ' << invariant->name;
      EXPECT_EQ(found.skipped, count.skipped) << subject.name << ' ' << invariant->name;
      violated += count.violated;
    }
    EXPECT_GT(violated, 0U) << subject.name;
  });
}

TEST_P(Drivers, TheKitHoldsWhereAReplayHolds) {
  for_each_subject([&](const Subject& subject, const Claim& claim) {
    const std::vector<conformance::Statement> statements =
        conformance::statements(subject, {.families = {"generic", "near_special"}});
    for_each_case([&](const Family& family, const Case& one) {
      const auto is_of_family = [&](const conformance::Statement& statement) { return statement.family == &family; };
      if (!std::ranges::any_of(statements, is_of_family)) {
        return;
      }
      const auto statuses = statuses_of(replayed(claim, subject, one));
      for (const conformance::Statement& statement : statements) {
        if (is_of_family(statement) && statuses.contains(statement.invariant)) {
          EXPECT_EQ(conformance::Examination(statement).holds(one),
                    statuses.at(statement.invariant) != Status::violated)
              << subject.name << ' ' << statement.invariant->name;
        }
      }
    });
  });
}

TEST_P(Drivers, TheThreePropertiesHoldWhereTheirInvariantsDo) {
  for_each_subject([&](Subject subject, Claim claim) {
    subject.law = Law::any;
    claim = properties::claim_of(subject, {});
    for_each_case([&](const Family&, const Case& one) {
      const auto statuses = statuses_of(replayed(claim, subject, one));
      for (const properties::Property& property : properties::three_properties()) {
        if (property.name == "positive_definiteness") {
          continue;  // the planted answers show no matrix
        }
        const properties::PropertyOptions options{.precision = GetParam()};
        const bool is_violated = std::ranges::any_of(property.invariants, [&](std::string_view name) {
          const auto found = statuses.find(properties::invariant_named(name));
          return found != statuses.end() && found->second == Status::violated;
        });
        EXPECT_EQ(properties::detail::ruling(
                      {property.name, one.collision, answer_of(subject, one.collision), GetParam()}, options)
                      .holds,
                  !is_violated)
            << subject.name << ' ' << property.name;
      }
    });
  });
}

TEST_P(Drivers, APlanAcceptsWhatAReplayAccepts) {
  for_each_subject([&](Subject subject, Claim claim) {
    subject.precision = Precision::binary64;  // a plan judges by the ulps of binary64
    claim = without_relations(properties::claim_of(subject, {}));
    properties::plan::Candidate candidate;
    candidate.subject = subject;
    const properties::plan::Demand demand{.law = subject.law};
    for_each_case([&](const Family&, const Case& drawn) {
      const Case one{drawn.collision, false};
      const Judgement judgement = replayed(claim, subject, one);
      if (!judgement.unjudged) {
        const properties::plan::Certifier certifier(one.collision, demand);
        EXPECT_EQ(certifier.judge(candidate, answer_of(subject, one.collision)).failure.empty(),
                  !is_violated(judgement))
            << subject.name;
      }
    });
  });
}

TEST_P(Drivers, ASceneCountsTheVerdictsOfReplays) {
  for_each_subject([&](const Subject& subject, const Claim& claim) {
    if (GetParam() == Precision::extended) {
      return;  // a scene stores its outcomes in binary64
    }
    properties::ImpulseJudge judge(subject.law, GetParam(), 1, {});
    std::map<std::string_view, std::uint64_t> held;
    std::uint64_t violated = 0;
    for_each_case([&](const Family&, const Case& drawn) {
      const Case one{drawn.collision, true};
      const Judgement judgement = replayed(without_relations(claim), subject, one);
      for (const auto& [invariant, status] : statuses_of(judgement)) {
        if (status == Status::holds) {
          ++held[invariant->name];
        }
      }
      violated += is_violated(judgement) ? 1 : 0;
      scene::Event event;
      event.has_impulse = true;
      event.collision = one.collision;
      event.outcome =
          map_outcome<double>(answer_of(subject, one.collision), [](long double x) { return static_cast<double>(x); });
      judge.record(event);
    });
    EXPECT_EQ(judge.times_held(), held) << subject.name;
    EXPECT_EQ(judge.violated(), violated) << subject.name;
  });
}

INSTANTIATE_TEST_SUITE_P(Each, Drivers, testing::Values(Precision::binary32, Precision::binary64, Precision::extended),
                         [](const auto& one) { return std::string(name_of(one.param)); });

}  // namespace
}  // namespace carom::equality
