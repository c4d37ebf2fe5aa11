// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <optional>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/oracles/laws/judge_error.hpp>

namespace carom::properties {

/// A subject threw an exception that is no SessionFailure, or gave too few or too many answers.
class SubjectError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// call(), which calls the subject. An exception of the subject becomes a SubjectError, so that it differs from a fault
/// of the judge.
template <class Call>
auto of_subject(const Call& call) {
  try {
    return call();
  } catch (const SessionFailure&) {
    throw;
  } catch (const oracles::JudgeError&) {
    throw;
  } catch (const std::exception& error) {
    throw SubjectError(error.what());
  }
}

/// The answers of a session, one for each collision. Throws SessionFailure or SubjectError.
[[nodiscard]] std::vector<Answer> answers_of(Session& session, std::span<const Collision> collisions);

/// Counts the failures of a subject and limits them. Threads may share it.
class Restarts {
 public:
  /// The subject is not started again after `most` failures, or after failures that took `longest` in total.
  explicit Restarts(unsigned most, std::optional<std::chrono::nanoseconds> longest = {})
      : most_(most), longest_(longest) {}

  /// Records a failure. Returns whether the subject may be started again.
  [[nodiscard]] bool may_restart_after(std::chrono::nanoseconds took);

  [[nodiscard]] unsigned most() const { return most_; }
  [[nodiscard]] bool are_spent() const { return are_spent_; }

 private:
  unsigned most_;
  std::optional<std::chrono::nanoseconds> longest_;
  std::atomic<unsigned> failures_ = 0;
  std::atomic<std::chrono::nanoseconds::rep> nanoseconds_ = 0;
  std::atomic<bool> are_spent_ = false;
};

/// A session that continues after a failure: the answer is Failed, and the subject is started again. Throws
/// SessionFailure if `restarts` forbids this, if the subject cannot start again, or if a stop is requested. Throws
/// SubjectError if the subject cannot start at first. `restarts` must outlive the session.
[[nodiscard]] Session open_restarting(const Subject& subject, Restarts& restarts, std::stop_token stop = {});

}  // namespace carom::properties
