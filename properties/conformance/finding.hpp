// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/conformance/examination.hpp>
#include <carom/properties/conformance/falsified.hpp>
#include <carom/rapidcheck.hpp>

namespace carom::conformance {

struct Finding {
  properties::Status status;  // skipped if no case was in the domain, or the subject is absent
  std::string text;           // the violation, or the reason for the skip; empty if the statement holds
};

/// Tests a statement on cases that RapidCheck draws. `name` is the property's name for RapidCheck.
[[nodiscard]] inline Finding find(const Statement& statement, const std::string& name = {}) {
  using properties::Status;
  const Subject& subject = *statement.subject;
  if (!subject.absent.empty()) {
    return {Status::skipped, subject.name + " is absent: " + subject.absent};
  }
  Examination examination(statement);
  const bool is_violated =
      falsified(name, [&] { RC_ASSERT(examination.holds(*gen::cases(statement.family->generate))); });
  const std::string invariant(statement.invariant->name);
  const std::string family(statement.family->name);
  if (is_violated) {
    return {Status::violated, subject.name + " violates " + invariant + " in " + family + "; shrunk:\n  " +
                                  std::string(statement.invariant->statement) + '\n' + examination.violation()};
  }
  if (!examination.was_in_domain()) {
    return {Status::skipped, "no case of " + family + " is in the domain of " + invariant + " (" +
                                 std::string(statement.invariant->domain) +
                                 "); first case: " + examination.why_skipped()};
  }
  return {Status::holds, ""};
}

}  // namespace carom::conformance
