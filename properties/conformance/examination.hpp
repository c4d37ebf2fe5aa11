// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>

#include <carom/properties/conformance/statement.hpp>
#include <carom/properties/trial/trial.hpp>

namespace carom::conformance {

/// Holds a statement against cases, all put to one session of the subject.
class Examination {
 public:
  /// Precondition: the subject is not absent, and the statement outlives the examination.
  explicit Examination(const Statement& statement);

  /// Whether the statement holds of the case. A subject that throws violates every invariant. After the first
  /// violation, one that is much less serious does not count, so that a case shrinks to one that shows the fault as
  /// plainly. After a session has failed, every case holds.
  [[nodiscard]] bool holds(const properties::Case& one);

  [[nodiscard]] bool was_in_domain() const { return was_in_domain_; }

  /// Why the first case that was skipped was; empty where none was.
  [[nodiscard]] const std::string& why_skipped() const { return why_skipped_; }

  /// The last violation in words. Precondition: there is one.
  [[nodiscard]] std::string violation();

 private:
  [[nodiscard]] properties::Verdict verdict_on(const properties::Case& one);

  const Statement* statement_;
  properties::Claim claim_;
  Session session_;
  Answer answer_;            // to the last case
  bool has_failed_ = false;  // the session is then of no further use
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
