// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <deque>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/properties/gate/answers.hpp>

namespace carom::tool::chart {

/// Subjects, each with an open session. A program is started again after a failure. After a hundred failures, or after
/// failures that took a minute, its answers are Skipped.
class ChartedSubjects {
 public:
  explicit ChartedSubjects(std::vector<Subject> subjects, std::stop_token stop = {});
  ChartedSubjects(const ChartedSubjects&) = delete;
  ChartedSubjects& operator=(const ChartedSubjects&) = delete;

  [[nodiscard]] std::span<const Subject> subjects() const { return subjects_; }

  /// Why a subject gave no further answers, with its name. Empty if none stopped.
  [[nodiscard]] const std::string& failure() const { return failure_; }

  /// The answers of each subject to the collisions, in the order of the subjects.
  [[nodiscard]] std::vector<std::vector<Answer>> answers_to(std::span<const Collision> collisions);

  /// Ends the sessions that are not over. Throws if a subject does not end as it should.
  void close();

 private:
  std::vector<Subject> subjects_;
  std::deque<properties::Restarts> restarts_;  // the sessions refer to the elements
  std::vector<Session> sessions_;
  std::vector<bool> are_over_;
  std::string failure_;
};

}  // namespace carom::tool::chart
