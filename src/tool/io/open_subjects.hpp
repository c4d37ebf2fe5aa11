// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/properties/gate/witness.hpp>
#include <carom/properties/trial/restarts.hpp>
#include <carom/properties/trial/trial.hpp>

#include "io/input_file.hpp"
#include "io/usage_error.hpp"

/// The subjects that a replay judges.
namespace carom::tool {

/// What came of a collision.
struct ReplayedCase {
  Answer answer;
  properties::Judgement judgement;
  // Of a program:
  std::size_t spellings = 0;           // in which it was asked; 0 of what is asked without a request
  std::size_t violated_spellings = 0;  // of them
  std::string spelt = {};              // the collision in that of the answer
};

/// A subject with its sessions, for all the collisions that are to be judged on it. A program is judged in a session
/// for each spelling of a request, since a fault may lie in its reader.
class OpenSubject {
 public:
  /// Throws UsageError where the subject cannot be run.
  OpenSubject(const std::string& name, double timeout_seconds, const oracles::Yardstick& yardstick,
              const std::stop_token& stop);

  [[nodiscard]] const Subject& subject() const { return subject_; }
  [[nodiscard]] const properties::Claim& claim() const { return claim_; }

  /// In the first spelling that shows a violation, else in the first of all. Of a program, `memoryless` says whether
  /// all spellings had the same answer. Throws UsageError.
  [[nodiscard]] ReplayedCase judge(const properties::Case& one);

  /// Throws UsageError where a session does not end as it should.
  void close();

 private:
  Subject subject_;
  properties::Claim claim_;
  // Sessions refer to them, and this is moved.
  std::unique_ptr<std::deque<properties::Restarts>> restarts_ = std::make_unique<std::deque<properties::Restarts>>();
  std::vector<Session> sessions_;  // of a program by spelling; else one
};

/// Each started once.
class OpenSubjects {
 public:
  /// `subject`: the one that judges all; empty if each file says which. `timeout_seconds`: of each reply of a program.
  OpenSubjects(std::string subject, double timeout_seconds, const oracles::Yardstick& yardstick, std::stop_token stop);

  /// The subject to judge on this collision; nullptr where there is none. Throws UsageError.
  [[nodiscard]] OpenSubject* subject_for(const ReadCollision& read);

  /// Why there is none, where the file names a subject; empty elsewhere. A file starts no programs: that takes the word
  /// of whoever runs this one.
  [[nodiscard]] std::string why_none(const ReadCollision& read) const;

  void close();

 private:
  OpenSubject& named(const std::string& name);

  std::string subject_;
  double timeout_seconds_;
  std::stop_token stop_;
  oracles::Yardstick yardstick_;
  std::map<std::string, OpenSubject> open_;
};

[[nodiscard]] bool is_violated(const properties::Judgement& judgement);

}  // namespace carom::tool
