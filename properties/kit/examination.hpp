// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <exception>
#include <optional>
#include <string>

#include <carom/properties/gate/trial.hpp>
#include <carom/properties/kit/statement.hpp>

namespace carom::conformance {

struct Finding {
  properties::Status status;  // skipped if no case was judged
  std::string text;           // the violation, or the reason for the skip; empty if the statement holds
};

/// Tests a statement on cases, in one session of the subject.
class Examination {
 public:
  /// Preconditions: `absent` of the subject is empty, and so is `ended` of the suite.
  explicit Examination(const Statement& statement);

  /// Whether the statement holds on the case. A subject that throws violates every invariant. After the first
  /// violation, a much less serious violation counts as holding, so that shrinking ends at a plain fault. After the
  /// session or the judge has failed, every case counts as holding.
  [[nodiscard]] bool holds(const properties::Case& one);

  /// The finding on these cases, for the test with this name. Keeps the facts in the suite that its other tests need.
  /// Rethrows an exception of the judge.
  [[nodiscard]] Finding finding(const std::string& test);

  /// Whether each invariant of a suite was judged in this process. Poses cases of its families to find it out. The
  /// finding is a violation that lists the invariants which no case judges. Precondition: the statements are those of
  /// one suite, in the order of `statements`.
  friend Finding finding_of_judged(const std::vector<Statement>& statements, const std::string& test);

 private:
  /// The subject's answer. Throws SubjectEnded if the subject throws.
  [[nodiscard]] Answer ask(const Collision& collision);
  [[nodiscard]] properties::Verdict verdict_on(const properties::Case& one);
  [[nodiscard]] properties::Verdict verdict_of_session(const properties::AboutSession& about,
                                                       const Collision& collision);
  /// Whether the subject threw in the last violation.
  [[nodiscard]] bool has_ended() const { return last_ && last_->has_ended; }
  [[nodiscard]] std::string violation();
  [[nodiscard]] std::string why_skipped() const;

  Statement statement_;
  properties::Claim claim_;
  Session session_;
  Answer answer_;
  bool has_thrown_ = false;  // in place of its last answer
  bool has_failed_ = false;  // then the session cannot continue
  std::exception_ptr error_of_judge_;
  struct Violation {
    properties::Case one;
    properties::Verdict verdict;
    Answer answer;
    bool has_ended;  // the subject threw
  };
  std::optional<Violation> first_;
  std::optional<Violation> last_;
  bool was_judged_ = false;
  std::string why_outside_;     // the reason why the first skipped case was skipped; empty if none was
  std::string why_no_outcome_;  // the fault of the first answer that is no outcome; empty if there is none
};

/// The statement's finding without a test, because the subject is absent or has ended. None if there is a test to make.
[[nodiscard]] std::optional<Finding> finding_without_test(const Statement& statement);

[[nodiscard]] Finding finding_of_judged(const std::vector<Statement>& statements, const std::string& test);

}  // namespace carom::conformance
