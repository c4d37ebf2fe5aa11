// SPDX-License-Identifier: BSL-1.0
#include "chart/charted_subjects.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <carom/properties/trial/answers.hpp>

namespace carom::tool::chart {

ChartedSubjects::ChartedSubjects(std::vector<Subject> subjects, std::stop_token stop) : subjects_(std::move(subjects)) {
  constexpr unsigned most_failures = 100;
  for (const Subject& subject : subjects_) {
    sessions_.push_back(properties::open_restarting(subject, restarts_.emplace_back(most_failures), stop));
  }
}

std::vector<std::vector<Answer>> ChartedSubjects::answers_to(std::span<const Collision> collisions) {
  constexpr std::size_t most_at_once = 50;  // as the gate asks
  std::vector<std::vector<Answer>> answers(sessions_.size());
  for (std::size_t s = 0; s < sessions_.size(); ++s) {
    for (std::size_t first = 0; first < collisions.size(); first += most_at_once) {
      const auto asked = collisions.subspan(first, std::min(most_at_once, collisions.size() - first));
      std::ranges::move(properties::answers_of(sessions_[s], asked), std::back_inserter(answers[s]));
    }
  }
  return answers;
}

void ChartedSubjects::close() {
  for (Session& session : sessions_) {
    session.close();
  }
}

}  // namespace carom::tool::chart
