// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/conformance/statement.hpp>
#include <carom/properties/trial/trial.hpp>

namespace carom::conformance {

/// Holds a statement against cases, all put to one session of the subject.
class Examination {
 public:
  /// Precondition: the subject is not absent, and the statement outlives the examination.
  explicit Examination(const Statement& statement);

  /// A subject that throws violates every invariant.
  [[nodiscard]] properties::Verdict judge(const properties::Case& one);

  [[nodiscard]] int judged() const { return judged_; }
  [[nodiscard]] bool was_in_domain() const { return was_in_domain_; }

  /// Why the first case that was skipped was; empty where none was.
  [[nodiscard]] const std::string& why_skipped() const { return why_skipped_; }

  /// A violation in words, shrunk to a case with small dyadic numbers that violates the invariant about as badly.
  /// Precondition: `one` is the case that was judged last, and `found`, its verdict, a violation.
  [[nodiscard]] std::string violation(const properties::Case& one, const properties::Verdict& found);

 private:
  [[nodiscard]] properties::Verdict verdict_on(const properties::Case& one);

  const Statement* statement_;
  properties::Claim claim_;
  Session session_;
  Answer answer_;            // to the last case
  bool has_failed_ = false;  // the session is then of no further use
  int judged_ = 0;
  bool was_in_domain_ = false;
  std::string why_skipped_;
};

}  // namespace carom::conformance
