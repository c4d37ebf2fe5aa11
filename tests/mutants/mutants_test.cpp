// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>
#include <ostream>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/shrink.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/properties/gate/witness.hpp>

#include "catalogue.hpp"
#include "support/cases.hpp"

namespace carom::mutants {
namespace {

using properties::Status;
using Rejecting = std::set<std::string_view>;

std::string joined(const Rejecting& names) { return fmt::format("{}", fmt::join(names, " ")); }

/// A solver that the judge examines.
struct Suspect {
  std::string name;
  Subject subject;
  std::string_view rejected_by;  // names of invariants
  bool by_no_other = false;      // whether other invariants must accept the solver
};

void PrintTo(const Suspect& suspect, std::ostream* out) { *out << suspect.name; }

/// The mutants, the solvers that break one of the three properties, and these solvers without a defect.
std::vector<Suspect> all_suspects() {
  std::vector<Suspect> all;
  for (const Mutant& mutant : all_mutants()) {
    all.push_back({std::string(mutant.name), subject_of(mutant), mutant.rejected_by});
  }
  // A law that determines no outcome has no truth to compare with.
  for (const char* name : {"resting_pushed_apart", "resting_pushed_aside"}) {
    all.push_back({std::string(name) + "_of_any_law", subject_of(mutant_named(name)), "impulse_bound"});
    all.back().subject.law = Law::any;
  }
  for (const BrokenProperty& broken : broken_properties()) {
    all.push_back({std::string(broken.name), subject_of(broken), broken.violates, true});
  }
  for (const Law law : {Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb}) {
    all.push_back({"repaired_" + std::string(name_of(law)), make_subject("repaired", law, {}), "", true});
  }
  for (Subject& subject : unbroken_subjects()) {
    all.push_back({"unbroken_" + subject.name, std::move(subject), "", true});
  }
  return all;
}

/// A suspect during the pass over the families. An invariant that rejects the suspect is not evaluated again.
class JudgedSuspect {
 public:
  explicit JudgedSuspect(const Subject& subject)
      : claim_(properties::claim_of(subject, {})),
        sameness_(properties::sameness_of_answers(subject)),
        session_(subject.open()) {}

  void judge(const properties::JudgedCase& judged_case, bool is_asked_again) {
    const auto solve = [&](const Collision& collision) {
      const Answer answer = ask(collision);
      if (std::exchange(is_asked_again, false)) {
        asked_.emplace_back(collision, answer);
      }
      return properties::lift(answer);
    };
    for (const auto& [invariant, verdict] : try_case(judged_case, claim_, solve).verdicts) {
      if (verdict.status == Status::violated) {
        rejecting_.insert(invariant->name);
        std::erase(claim_.invariants, invariant);
      }
    }
  }

  /// Asks again what was asked long ago. Returns the names of all invariants that reject the suspect.
  [[nodiscard]] Rejecting closed() {
    for (const properties::Invariant* invariant : claim_.invariants) {
      if (const auto* about = std::get_if<properties::AboutSession>(&invariant->about)) {
        for (const auto& [collision, answer] : asked_) {
          if (about->check(answer, ask(collision), sameness_).status == Status::violated) {
            rejecting_.insert(invariant->name);
          }
        }
      }
    }
    return rejecting_;
  }

 private:
  [[nodiscard]] Answer ask(const Collision& collision) { return session_(std::span(&collision, 1)).at(0); }

  properties::Claim claim_;
  properties::Sameness sameness_;
  Session session_;
  Rejecting rejecting_;
  std::vector<std::pair<Collision, Answer>> asked_;
};

/// The pass draws each case once. All suspects whose tests are selected answer it, and all invariants judge the
/// answers.
class Suspects : public testing::TestWithParam<Suspect> {
 protected:
  static void SetUpTestSuite() {
    constexpr std::uint64_t seed = 1;
    constexpr std::uint64_t cases_of_each_family = 150;
    constexpr std::uint64_t asked_again_every = 10;
    std::vector<std::pair<std::string, JudgedSuspect>> suspects;
    for (const Suspect& suspect : all_suspects()) {
      if (unit::is_selected(suspect.name)) {
        suspects.emplace_back(suspect.name, suspect.subject);
      }
    }
    for (const properties::Family& family : properties::all_families()) {
      for (std::uint64_t i = 0; i < cases_of_each_family * static_cast<std::uint64_t>(family.weight); ++i) {
        const properties::JudgedCase judged_case(properties::drawn_case(family, seed, i));
        for (auto& [name, suspect] : suspects) {
          suspect.judge(judged_case, i % asked_again_every == 0);
        }
      }
    }
    for (auto& [name, suspect] : suspects) {
      rejecting_invariants[name] = suspect.closed();
    }
  }

  static inline std::map<std::string, Rejecting> rejecting_invariants;
};

TEST_P(Suspects, AreRejectedByTheInvariantsThatSpeakOfTheirDefect) {
  const Suspect& suspect = GetParam();
  const Rejecting& rejecting = rejecting_invariants.at(suspect.name);
  const std::vector<std::string_view> names = names_in(suspect.rejected_by);
  const Rejecting expected(names.begin(), names.end());
  RecordProperty("rejected_by", joined(rejecting));
  EXPECT_TRUE(std::ranges::includes(rejecting, expected)) << "rejected by: " << joined(rejecting);
  EXPECT_TRUE(!suspect.by_no_other || rejecting == expected) << "rejected by: " << joined(rejecting);
}

INSTANTIATE_TEST_SUITE_P(Each, Suspects, testing::ValuesIn(all_suspects()),
                         [](const auto& test) { return test.param.name; });

/// An invariant other than `backward_error` rejects each mutant, with two exceptions: mutants that lose digits, and
/// mutants of `rough` whose friction has a wrong size.
TEST(MutantCatalogue, NeedsTheTruthOnlyForLostDigitsAndSizesOfFriction) {
  Rejecting by_the_truth_alone;
  for (const Mutant& mutant : all_mutants()) {
    if (mutant.rejected_by == "backward_error") {
      by_the_truth_alone.insert(mutant.name);
    }
  }
  EXPECT_EQ(by_the_truth_alone, (Rejecting{"outcome_to_ten_digits", "outcome_in_float", "friction_before_restitution",
                                           "tangential_restitution_ignored", "tangential_restitution_reversed"}));
}

/// Together with Suspects.AreRejected…, this test shows that no invariant is vacuous.
TEST(MutantCatalogue, HasAMutantForEveryInvariant) {
  Rejecting rejecting;
  for (const Mutant& mutant : all_mutants()) {
    const std::vector<std::string_view> names = names_in(mutant.rejected_by);
    EXPECT_FALSE(names.empty()) << mutant.name;
    rejecting.insert(names.begin(), names.end());
  }
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    EXPECT_TRUE(rejecting.contains(invariant.name)) << invariant.name << " rejects no mutant";
  }
}

/// If the contact point is the world's origin, a lost impulse has no moment about the origin.
TEST(LinearMomentum, IsViolatedWithoutAngularMomentumByAnImpulseLostAtTheOrigin) {
  const auto broken = std::ranges::find(broken_properties(), "heavier_gets_less", &BrokenProperty::name);
  const Subject subject = subject_of(*broken);
  const properties::Claim claim = properties::claim_of(subject, {});
  int violated = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    properties::Case one = properties::drawn_case(*properties::family_named("generic"), 1, i);
    one.collision.a.position -= one.collision.point;
    one.collision.b.position -= one.collision.point;
    one.collision.point.setZero();
    for (const auto& [invariant, verdict] : judge_one(subject, claim, one).judgement.verdicts) {
      if (verdict.status == Status::violated) {
        EXPECT_TRUE(invariant->name == "linear_momentum" || invariant->name == "impulse_bound")
            << invariant->name << ' ' << i;
        violated += invariant->name == "linear_momentum" ? 1 : 0;
      }
    }
  }
  EXPECT_GT(violated, 50);
}

Status status_of(const properties::SubjectResult& result, const properties::Invariant* invariant,
                 const properties::Case& one) {
  properties::Claim claim = properties::claim_of(result.subject, {});
  claim.invariants = {invariant};
  const properties::Judgement judgement = judge_one(result.subject, claim, one).judgement;
  return judgement.verdicts.empty() ? Status::skipped : judgement.verdicts.front().verdict.status;
}

TEST(Witnesses, OfMutantsAreSimplerCollisionsThatStillViolateTheirInvariant) {
  properties::GateOptions options;
  options.cases = 50;
  options.is_part = true;
  options.families = {properties::family_named("generic"), properties::family_named("separating")};
  const properties::GateReport report =
      run_gate({subject_of(mutant_named("separating_pulled")), subject_of(mutant_named("wrong_mass_in_reaction")),
                make_subject("repaired", Law::frictionless, {})},
               options);
  EXPECT_TRUE(report.results.at(2).is_sound());
  for (const properties::SubjectResult& rejected : std::span(report.results).first(2)) {
    EXPECT_EQ(rejected.error, "");
    EXPECT_FALSE(rejected.is_sound());
    EXPECT_EQ(rejected.witnesses.size(), rejected.violated_invariants().size());
    ASSERT_FALSE(rejected.witnesses.empty());
    for (const properties::Witness& witness : rejected.witnesses) {
      SCOPED_TRACE(witness.invariant->name);
      EXPECT_EQ(witness.verdict.status, Status::violated);
      EXPECT_GT(witness.verdict.residual, witness.verdict.allowed);
      EXPECT_TRUE(validate(witness.shrunk.collision).empty());
      EXPECT_EQ(status_of(rejected, witness.invariant, witness.original), Status::violated);
      EXPECT_EQ(status_of(rejected, witness.invariant, witness.shrunk), Status::violated);
      EXPECT_LT(properties::complexity(witness.shrunk.collision), properties::complexity(witness.original.collision));
    }
  }
  const auto& witnesses = report.results.at(0).witnesses;
  const auto push =
      std::ranges::find_if(witnesses, [](const properties::Witness& one) { return one.invariant->name == "push"; });
  ASSERT_NE(push, witnesses.end());
  // The simplest collisions (at the origin with r_A = r_B = 0, unit masses, one velocity) have a complexity below 40. A
  // general collision has thousands.
  constexpr long textbook = 40;
  EXPECT_LT(properties::complexity(push->shrunk.collision), textbook);
}

}  // namespace
}  // namespace carom::mutants
