// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <stop_token>

#include <carom/collision/subject.hpp>

namespace carom::properties {

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
