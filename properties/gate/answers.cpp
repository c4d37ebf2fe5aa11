// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <carom/properties/gate/answers.hpp>

namespace carom::properties {

std::vector<Answer> answers_of(Session& session, std::span<const Collision> collisions) {
  std::vector<Answer> answers = of_subject([&] { return session(collisions); });
  if (answers.size() != collisions.size()) {
    throw SubjectError("the session gave " + std::to_string(answers.size()) + " answers to " +
                       std::to_string(collisions.size()) + " collisions");
  }
  return answers;
}

}  // namespace carom::properties
