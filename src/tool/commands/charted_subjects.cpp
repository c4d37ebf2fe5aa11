// SPDX-License-Identifier: BSL-1.0
#include "commands/charted_subjects.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include <carom/properties/gate/answers.hpp>

namespace carom::tool::chart {

ChartedSubjects::ChartedSubjects(std::vector<Subject> subjects, std::stop_token stop)
    : subjects_(std::move(subjects)), are_over_(subjects_.size()) {
  constexpr unsigned most_failures = 100;
  for (const Subject& subject : subjects_) {
    properties::Restarts& restarts = restarts_.emplace_back(most_failures, std::chrono::minutes(1));
    sessions_.push_back(properties::open_restarting(subject, restarts, stop));
  }
}

std::vector<std::vector<Answer>> ChartedSubjects::answers_to(std::span<const Collision> collisions) {
  constexpr std::size_t most_at_once = 50;  // as the gate asks
  std::vector<std::vector<Answer>> answers(sessions_.size());
  for (std::size_t s = 0; s < sessions_.size(); ++s) {
    try {
      for (std::size_t first = 0; first < collisions.size() && !are_over_[s]; first += most_at_once) {
        const auto asked = collisions.subspan(first, std::min(most_at_once, collisions.size() - first));
        std::ranges::move(properties::answers_of(sessions_[s], asked), std::back_inserter(answers[s]));
      }
    } catch (const SessionFailure& failure) {
      std::ranges::copy(failure.answered(), std::back_inserter(answers[s]));
      are_over_[s] = true;
      failure_ = subjects_[s].name + ": " + failure.what();
    }
    answers[s].resize(collisions.size(), Skipped{});
  }
  return answers;
}

void ChartedSubjects::close() {
  for (std::size_t s = 0; s < sessions_.size(); ++s) {
    if (!are_over_[s]) {
      sessions_[s].close();
    }
  }
}

}  // namespace carom::tool::chart
