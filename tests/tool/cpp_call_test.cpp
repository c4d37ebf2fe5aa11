// SPDX-License-Identifier: BSL-1.0
#include "commands/cpp_call.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include <carom/impulse/batch/solve.hpp>
#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/guaranteed.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/impulse/refined.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/reflection_in_basis.hpp>
#include <carom/impulse/rough.hpp>
#include <carom/impulse/solve3_pivoting.hpp>
#include <carom/impulse/sticking.hpp>
#include <carom/impulse/world_inertia.hpp>
#include <carom/properties/gate/answers.hpp>

#include "support/cases.hpp"

namespace carom::tests {
namespace {

template <class S, class Solve>
ReportedOutcome solved_in_batch(const Collision& collision, const Solve& solve) {
  carom::impulse::ContactBatch<S> contacts(1);
  contacts.set(0, carom::impulse::make_contact<S>(collision));
  carom::impulse::OutcomeBatch<S> outcomes(1);
  solve(contacts, outcomes);
  return reported(outcomes.at(0));
}

struct Call {
  std::string subject;
  std::string text;
  std::function<ReportedOutcome(const Collision&)> solve;
};

// NOLINTBEGIN(cppcoreguidelines-macro-usage): the test compares the text of the call with the printed text
#define CALL(subject, ...)                                                                  \
  Call {                                                                                    \
    subject, #__VA_ARGS__, [](const Collision& collision) { return reported(__VA_ARGS__); } \
  }
#define BATCH_CALL(subject, scalar, ...)                                                                    \
  Call {                                                                                                    \
    subject, #__VA_ARGS__, [](const Collision& collision) {                                                 \
      return solved_in_batch<scalar>(collision, [](const auto& contacts, auto& outcomes) { __VA_ARGS__; }); \
    }                                                                                                       \
  }
// NOLINTEND(cppcoreguidelines-macro-usage)

/// Calls of every kind, most of them only in double.
const std::vector<Call>& calls() {
  // clang-format off
  static const std::vector<Call> all{
      CALL("frictionless-float", carom::impulse::frictionless(carom::impulse::make_contact<float>(collision))),
      CALL("frictionless-double", carom::impulse::frictionless(carom::impulse::make_contact<double>(collision))),
      CALL("frictionless-long-double", carom::impulse::frictionless(carom::impulse::make_contact<long double>(collision))),
      CALL("frictionless-double-double", carom::impulse::frictionless(carom::impulse::make_contact<carom::impulse::DoubleDouble>(collision))),
      CALL("reflection-double", carom::impulse::reflection<carom::impulse::Ldlt>(carom::impulse::make_contact<double>(collision))),
      CALL("sticking-double", carom::impulse::sticking<carom::impulse::Ldlt>(carom::impulse::make_contact<double>(collision))),
      CALL("rough-double", carom::impulse::rough<carom::impulse::Ldlt>(carom::impulse::make_contact<double>(collision))),
      CALL("coulomb-double", carom::impulse::coulomb(carom::impulse::make_contact<double>(collision))),
      CALL("reflection-adjugate-double", carom::impulse::reflection<carom::impulse::Adjugate>(carom::impulse::make_contact<double>(collision))),
      CALL("reflection-llt-double", carom::impulse::reflection<carom::impulse::EigenLlt>(carom::impulse::make_contact<double>(collision))),
      CALL("reflection-ldlt-eigen-double", carom::impulse::reflection<carom::impulse::EigenLdlt>(carom::impulse::make_contact<double>(collision))),
      CALL("reflection-partial-lu-double", carom::impulse::reflection<carom::impulse::EigenPartialPivLu>(carom::impulse::make_contact<double>(collision))),
      CALL("reflection-full-lu-double", carom::impulse::reflection<carom::impulse::EigenFullPivLu>(carom::impulse::make_contact<double>(collision))),
      CALL("reflection-qr-double", carom::impulse::reflection<carom::impulse::EigenColPivHouseholderQr>(carom::impulse::make_contact<double>(collision))),
      CALL("reflection-in-stable-basis-double", carom::impulse::reflection_in_stable_basis(carom::impulse::make_contact<double>(collision))),
      CALL("frictionless-world-float", carom::impulse::frictionless(carom::impulse::make_contact<float, carom::impulse::WorldInertia<float>>(collision))),
      CALL("frictionless-world-double", carom::impulse::frictionless(carom::impulse::make_contact<double, carom::impulse::WorldInertia<double>>(collision))),
      CALL("reflection-world-double", carom::impulse::reflection<carom::impulse::Ldlt>(carom::impulse::make_contact<double, carom::impulse::WorldInertia<double>>(collision))),
      CALL("sticking-world-double", carom::impulse::sticking<carom::impulse::Ldlt>(carom::impulse::make_contact<double, carom::impulse::WorldInertia<double>>(collision))),
      CALL("rough-world-double", carom::impulse::rough<carom::impulse::Ldlt>(carom::impulse::make_contact<double, carom::impulse::WorldInertia<double>>(collision))),
      CALL("frictionless-float-refined", carom::impulse::frictionless_refined<float>(carom::impulse::make_contact<double>(collision))),
      CALL("reflection-float-refined", carom::impulse::reflection_refined<float, carom::impulse::Ldlt>(carom::impulse::make_contact<double>(collision))),
      CALL("frictionless-guaranteed-double", carom::impulse::guaranteed(collision, carom::impulse::make_contact<double>(collision), [](const auto& contact, const auto&... approach) { return carom::impulse::frictionless_impulse(contact, approach...); })),
      CALL("reflection-guaranteed-double", carom::impulse::guaranteed(collision, carom::impulse::make_contact<double>(collision), [](const auto& contact, const auto&... approach) { return carom::impulse::reflection_impulse<carom::impulse::Ldlt>(contact, approach...); })),
      CALL("sticking-guaranteed-double", carom::impulse::guaranteed(collision, carom::impulse::make_contact<double>(collision), [](const auto& contact, const auto&... approach) { return carom::impulse::sticking_impulse<carom::impulse::Ldlt>(contact, approach...); })),
      CALL("rough-guaranteed-double", carom::impulse::guaranteed(collision, carom::impulse::make_contact<double>(collision), [](const auto& contact, const auto&... approach) { return carom::impulse::rough_impulse<carom::impulse::Ldlt>(contact, approach...); })),
      BATCH_CALL("frictionless-batch-float", float, carom::impulse::solve(contacts, carom::Law::frictionless, outcomes)),
      BATCH_CALL("frictionless-batch-double", double, carom::impulse::solve(contacts, carom::Law::frictionless, outcomes)),
      BATCH_CALL("reflection-batch-double", double, carom::impulse::solve(contacts, carom::Law::reflection, outcomes)),
      BATCH_CALL("sticking-batch-double", double, carom::impulse::solve(contacts, carom::Law::sticking, outcomes)),
      BATCH_CALL("rough-batch-double", double, carom::impulse::solve(contacts, carom::Law::rough, outcomes)),
  };
  // clang-format on
  return all;
}

std::string in_double(std::string text) {
  for (const char* scalar : {"long double", "carom::impulse::DoubleDouble", "float"}) {
    const std::string as_argument = std::string("<") + scalar;
    for (std::size_t at = text.find(as_argument); at != std::string::npos; at = text.find(as_argument, at)) {
      text.replace(at, as_argument.size(), "<double");
    }
  }
  return text;
}

TEST(PlanSpelling, IsCompiledForEveryMethod) {
  std::set<std::string> compiled;
  for (const Call& call : calls()) {
    compiled.insert(call.text);
    compiled.insert(in_double(call.text));
  }
  const auto candidates = tool::plan::callable_candidates();
  EXPECT_GT(candidates.size(), 50U);
  for (const tool::plan::CallableCandidate& one : candidates) {
    EXPECT_TRUE(compiled.contains(in_double(one.code.call))) << one.candidate.subject.name << ": " << one.code.call;
  }
}

TEST(PlanSpelling, AnswersAsTheSubjectDoes) {
  const auto candidates = tool::plan::callable_candidates();
  for (const Call& call : calls()) {
    const auto found =
        std::ranges::find_if(candidates, [&](const auto& one) { return one.candidate.subject.name == call.subject; });
    ASSERT_NE(found, candidates.end()) << call.subject;
    EXPECT_EQ(found->code.call, call.text);
    Session session = found->candidate.subject.open();
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Collision collision = unit::case_of("physical", i).collision;
      const std::vector<Answer> answers = properties::answers_of(session, {&collision, 1});
      const ReportedOutcome solved = call.solve(collision);
      const auto of_subject = vectors(std::get<ReportedOutcome>(answers[0]));
      const auto of_call = vectors(solved);
      for (const OutcomeVector k : all_outcome_vectors) {
        EXPECT_EQ(*of_subject[k], *of_call[k]) << call.subject << ' ' << i;
      }
    }
  }
}

TEST(PlanSpelling, NamesHeadersThatThereAre) {
  for (const tool::plan::CallableCandidate& one : tool::plan::callable_candidates()) {
    EXPECT_FALSE(one.code.headers.empty());
    for (const std::string& header : one.code.headers) {
      const std::string under_src = std::string(CAROM_SOURCE_DIR) + "/src" + header.substr(std::string("carom").size());
      EXPECT_TRUE(std::filesystem::exists(under_src)) << under_src;
    }
  }
}

TEST(PlanSpelling, LeavesOutTheBasisThatFailsNearHeadOn) {
  for (const tool::plan::CallableCandidate& one : tool::plan::callable_candidates()) {
    EXPECT_EQ(one.candidate.subject.name.find("in-basis"), std::string::npos);
  }
}

TEST(PlanSpelling, SaysWhatEachComputesIn) {
  const auto found = [](const std::string& name) {
    const auto all = tool::plan::callable_candidates();
    return std::ranges::find_if(all, [&](const auto& one) { return one.candidate.subject.name == name; })->candidate;
  };
  EXPECT_EQ(found("reflection-long-double").scalar, "long double");
  EXPECT_EQ(found("reflection-double-double").scalar, "double-double");
  EXPECT_LT(found("rough-float").scalar_rank, found("rough-double").scalar_rank);
  EXPECT_EQ(found("frictionless-double").solve, "scalar");
  EXPECT_EQ(found("reflection-double").solve, "LDLᵀ");
  EXPECT_EQ(found("sticking-world-float").frame, properties::plan::Frame::world);
  EXPECT_TRUE(found("rough-batch-float").is_batch);
}

}  // namespace
}  // namespace carom::tests
