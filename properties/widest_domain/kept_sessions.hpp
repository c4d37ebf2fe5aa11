// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <deque>
#include <functional>
#include <memory>

#include <carom/collision/subject.hpp>

namespace carom::properties {

/// Keeps the sessions of a program from one run of the gate to the next, because a program may take a second to start.
/// The sessions end with this object. Only the thread that made this object may use its subject.
class KeptSessions {
 public:
  explicit KeptSessions(const Subject& subject);
  KeptSessions(const KeptSessions&) = delete;  // the subject refers to this object
  KeptSessions& operator=(const KeptSessions&) = delete;

  /// The subject with other sessions: `open` takes a session that is not in use, and `close` gives it back. Two
  /// sessions take turns, so a session and the next one are not the same.
  [[nodiscard]] const Subject& subject() const { return subject_; }

 private:
  struct Kept {
    Session session;
    bool has_failed = false;
  };

  Session take();

  Subject subject_;
  std::function<Session()> open_;
  std::shared_ptr<std::deque<std::shared_ptr<Kept>>> idle_;
};

}  // namespace carom::properties
