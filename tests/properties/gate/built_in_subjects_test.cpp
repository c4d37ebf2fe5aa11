// SPDX-License-Identifier: BSL-1.0
#include <map>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/judge/exact_case.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/cases.hpp"
#include "support/changed_subject.hpp"

/// Each built-in subject that is expected to pass is sound, and each other one violates an invariant. If a subject
/// becomes sound, set its `expected_to_pass`.
namespace carom::properties {
namespace {

struct Number {
  std::uint64_t seed;
  std::uint64_t index;
  const char* family = "structured";
};

/// Rare cases of `structured` in which these subjects fail: the rounding of positions to binary32 moves the contact
/// point off a thin body.
const std::map<std::string, Number> rare{{"reflection-llt-float", {202, 75335}},
                                         {"reflection-ldlt-eigen-float", {1, 13500}},
                                         {"reflection-partial-lu-float", {1, 13500}},
                                         {"reflection-full-lu-float", {1, 32704}},
                                         {"reflection-qr-float", {5, 1618155}}};

/// Regression cases of sound subjects. The last tests the judge, and the others test solvers.
const std::vector<std::pair<std::string, Number>> mended{
    {"reflection-in-stable-basis-float", {101, 13155}},
    {"reflection-in-stable-basis-float", {202, 12285}},
    {"rough-float", {20261125, 42175}},
    {"rough-float", {303, 4026, "near_special"}},
    {"rough-batch-float", {20261125, 42175}},
    {"rough-double", {4, 32442, "needle_tip"}},
    {"rough-batch-double", {4, 32442, "needle_tip"}},
    {"rough-guaranteed-double", {4, 32442, "needle_tip"}},
    {"coulomb-float", {202, 12285}},
    {"coulomb-long-double", {303, 4004, "on_the_cone"}},
};

std::size_t violated_in(const Subject& subject, const Number& number) {
  const Case one = drawn_case(*family_named(number.family), number.seed, number.index);
  Session session = subject.open();
  const AnswerAndJudgement judged = judge_in_session(claim_of(subject, {}), session, one);
  std::size_t violated = 0;
  for (const NamedVerdict& named : judged.judgement.verdicts) {
    violated += named.verdict.status == Status::violated ? 1 : 0;
  }
  EXPECT_FALSE(judged.judgement.verdicts.empty()) << subject.name;
  return violated;
}

TEST(BuiltInSubjects, AreSoundIfTheyAreExpectedToPass) {
  std::vector<Subject> expected_to_pass = subjects::all_subjects();
  std::erase_if(expected_to_pass,
                [](const Subject& subject) { return !subject.expected_to_pass || !subject.absent.empty(); });
  for (const SubjectResult& result : run_gate(expected_to_pass, unit::gate_options(20)).results) {
    EXPECT_TRUE(result.is_sound()) << result.subject.name << ": " << result.error << result.not_judged;
    for (const Invariant* invariant : result.violated_invariants()) {
      ADD_FAILURE() << result.subject.name << " violates " << invariant->name;
    }
  }
}

TEST(BuiltInSubjects, ViolateAnInvariantIfTheyAreExpectedToFail) {
  GateOptions options = unit::gate_options(1000);
  options.fail_fast = true;
  options.shrinks = false;
  std::size_t kept = 0;
  for (const Subject& subject : subjects::all_subjects()) {
    if (subject.expected_to_pass || !subject.absent.empty()) {
      continue;
    }
    ++kept;
    const auto number = rare.find(subject.name);
    if (number != rare.end()) {
      EXPECT_GT(violated_in(subject, number->second), 0U) << subject.name;
    } else {
      EXPECT_FALSE(run_gate({subject}, options).results.at(0).violated_invariants().empty()) << subject.name;
    }
  }
  EXPECT_GT(kept, 20U);
}

/// In the cases of `rare`, `reflection-float` is sound, because its LDLᵀ raises each pivot to at least λ = 1/m_A +
/// 1/m_B. In double, each method of `rare` is sound.
TEST(BuiltInSubjects, AreSoundInOtherMethodsWhereARareCaseBreaksOne) {
  for (const auto& [name, number] : rare) {
    const std::string in_double = name.substr(0, name.rfind('-')) + "-double";
    for (const std::string& sound : {std::string("reflection-float"), std::string("reflection-double"), in_double}) {
      EXPECT_EQ(violated_in(subjects::subject_named(sound).value(), number), 0U) << sound << ", case of " << name;
    }
  }
}

TEST(BuiltInSubjects, AreSoundInTheCasesThatOnceBrokeThem) {
  for (const auto& [name, number] : mended) {
    EXPECT_EQ(violated_in(subjects::subject_named(name).value(), number), 0U) << name;
  }
}

/// If a built-in solver reports its matrix at all, it reports the matrix in every colliding case.
TEST(BuiltInSubjects, ShowTheirMatrixInEachCollidingCaseOrInNone) {
  for (const Subject& subject : subjects::built_in_subjects()) {
    int shown = 0;
    int changed = 0;
    Session session = subject.open();
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Collision collision = unit::case_of("sliding", i).collision;
      shown += std::get<ReportedOutcome>(session(std::span(&collision, 1)).at(0)).collision_matrix ? 1 : 0;
      changed += oracles::ExactCase(collision).state() == oracles::ContactState::colliding ? 1 : 0;
    }
    EXPECT_GT(changed, 5);
    EXPECT_EQ(shown, subject.shows_collision_matrix ? changed : 0) << subject.name;
    const bool forms_none = subject.law == Law::frictionless || subject.name.find("-batch-") != std::string::npos;
    EXPECT_EQ(subject.shows_collision_matrix, !forms_none) << subject.name;
  }
}

/// Without friction, `coulomb` needs no matrix. It shows the matrix all the same, because it claims so.
TEST(BuiltInSubjects, ShowTheirMatrixWithoutFrictionToo) {
  const Subject subject = subjects::subject_named("coulomb-double").value();
  Case one = unit::case_of("sliding", 0);
  Session session = subject.open();
  for (const double friction : {0.5, 0.0}) {
    one.collision.friction = friction;
    EXPECT_TRUE(std::get<ReportedOutcome>(session(std::span(&one.collision, 1)).at(0)).collision_matrix.has_value());
  }
}

}  // namespace
}  // namespace carom::properties
