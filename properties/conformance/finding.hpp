// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>

#include <carom/properties/conformance/examination.hpp>
#include <carom/properties/conformance/rapidcheck.hpp>

namespace carom::conformance {

/// What came of a statement.
struct Finding {
  properties::Status status;  // skipped where no case was in the invariant's domain
  std::string text;           // in words, what was violated or why it was skipped; empty where it holds
};

/// Holds a statement against cases that RapidCheck draws; its RC_PARAMS chooses another seed.
[[nodiscard]] inline Finding find(const Statement& statement) {
  using properties::Status;
  const Subject& subject = *statement.subject;
  if (!subject.absent.empty()) {
    return {Status::skipped, subject.name + " is absent: " + subject.absent};
  }
  Examination examination(statement);
  std::string violation;
  const rc::detail::TestParams parameters = properties::rapidcheck_parameters(statement.cases, false);
  const auto found = properties::counterexample(parameters, [&] {
    const properties::Case one = *properties::cases_of(*statement.family);
    if (violation.empty()) {  // RapidCheck runs a failing case once more
      const properties::Verdict verdict = examination.judge(one);
      violation = verdict.status == Status::violated ? examination.violation(one, verdict) : "";
    }
    RC_ASSERT(violation.empty());
  });
  const std::string invariant(statement.invariant->name);
  const std::string family(statement.family->name);
  if (!violation.empty()) {
    return {Status::violated, subject.name + " violates " + invariant + " in " + family + ", case " +
                                  std::to_string(examination.judged()) + " of " +
                                  std::to_string(parameters.maxSuccess) + "; shrunk:\n  " +
                                  std::string(statement.invariant->statement) + '\n' + violation +
                                  "  seed: RC_PARAMS=\"seed=" + std::to_string(parameters.seed) + "\"\n"};
  }
  if (found) {
    return {Status::violated, *found};
  }
  if (!examination.was_in_domain()) {
    return {Status::skipped, "no case of " + family + " is in the domain of " + invariant + " (" +
                                 std::string(statement.invariant->domain) + "); of the first, " +
                                 examination.why_skipped()};
  }
  return {Status::holds, ""};
}

}  // namespace carom::conformance
