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
#include <carom/report/pages/shown_case.hpp>

#include "io/input_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {

using report::ReplayedCase;

/// A subject with its sessions. A program has one session for each spelling (a way to write a request in JSON,
/// subjects/protocol/spelling.hpp), because a fault of its JSON reader may show in one spelling alone. A program that
/// reads hexadecimal numbers has as many sessions, so that `memoryless` is judged.
class ReplaySubject {
 public:
  /// Throws UsageError if the subject cannot be run.
  ReplaySubject(const std::string& name, double timeout_seconds, const oracles::Limits& limits,
                const properties::Domain& within, const std::stop_token& stop);

  [[nodiscard]] const Subject& subject() const { return subject_; }
  [[nodiscard]] const properties::Claim& claim() const { return claim_; }

  /// Judges the case in every spelling. Returns the result of the first spelling with a violation, otherwise of the
  /// first spelling. For a program, the invariant `memoryless` holds if the answers in all spellings are the same.
  /// Throws UsageError.
  [[nodiscard]] ReplayedCase judge(const properties::Case& one);

  /// Throws UsageError if a session does not end properly.
  void close();

 private:
  Subject subject_;
  properties::Claim claim_;
  // On the heap, because sessions refer to the elements and this object may be moved.
  std::unique_ptr<std::deque<properties::Restarts>> restarts_ = std::make_unique<std::deque<properties::Restarts>>();
  std::vector<Session> sessions_;  // one for each spelling of a program, otherwise one
};

/// The subjects of a replay, each started once.
class ReplaySubjects {
 public:
  /// `subject` judges every collision; if it is empty, each file names its subject. `timeout_seconds` is for each reply
  /// of a program. Relations are judged only if the related collisions lie in `within`.
  ReplaySubjects(std::string subject, double timeout_seconds, const oracles::Limits& limits, properties::Domain within,
                 std::stop_token stop);

  /// The subject that judges this collision; nullptr if there is none. Throws UsageError.
  [[nodiscard]] ReplaySubject* subject_for(const ReadCollision& read);

  /// The reason why no subject judges the collision although the file names one: a file cannot start programs.
  /// Otherwise empty.
  [[nodiscard]] std::string why_none(const ReadCollision& read) const;

  void close();

 private:
  ReplaySubject& named(const std::string& name);

  std::string subject_;
  double timeout_seconds_;
  std::stop_token stop_;
  oracles::Limits limits_;
  properties::Domain within_;
  std::map<std::string, ReplaySubject> open_;
};

}  // namespace carom::tool
