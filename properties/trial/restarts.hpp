// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <stop_token>

#include <carom/collision/subject.hpp>

namespace carom::properties {

/// How often a subject may fail before it is asked no more; threads may share it.
class Restarts {
 public:
  /// No more failures than `most`, and none after they took so long together.
  explicit Restarts(unsigned most, std::optional<std::chrono::nanoseconds> longest = {})
      : most_(most), longest_(longest) {}

  /// Books a failure that took so long; whether the subject may be started again.
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

/// A session of the subject that goes on where it fails: the collision is answered by Failed, the subject is started
/// again, and asked what comes after it. Throws SessionFailure where that was too often, it cannot be started again, or
/// a stop is requested. `restarts` must outlive the session.
[[nodiscard]] Session open_restarting(const Subject& subject, Restarts& restarts, std::stop_token stop = {});

}  // namespace carom::properties
