// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>

#include <carom/properties/conformance/statement.hpp>
#include <carom/properties/trial/trial.hpp>

namespace carom::conformance {

/// Tests a statement on cases, in one session of the subject.
class Examination {
 public:
  /// Preconditions: `absent` of the subject is empty; the statement outlives the examination.
  explicit Examination(const Statement& statement);

  /// Whether the statement holds on the case. A subject that throws violates every invariant. After the first
  /// violation, a much less serious violation counts as holding, so that shrinking ends at a plain fault. After the
  /// session has failed, every case counts as holding.
  [[nodiscard]] bool holds(const properties::Case& one);

  [[nodiscard]] bool was_in_domain() const { return was_in_domain_; }

  /// The reason for the first skipped case; empty if none was skipped.
  [[nodiscard]] const std::string& why_skipped() const { return why_skipped_; }

  /// The last violation in words. Precondition: `holds` returned false.
  [[nodiscard]] std::string violation();

 private:
  [[nodiscard]] properties::Verdict verdict_on(const properties::Case& one);

  const Statement* statement_;
  properties::Claim claim_;
  Session session_;
  Answer answer_;
  bool has_failed_ = false;  // then the session cannot continue
  struct Violation {
    properties::Case one;
    properties::Verdict verdict;
    Answer answer;
  };
  std::optional<Violation> first_;
  std::optional<Violation> last_;
  bool was_in_domain_ = false;
  std::string why_skipped_;
};

}  // namespace carom::conformance
