// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/collision/validate.hpp>

namespace carom::subjects {

/// A session that answers with `solve` (Collision → Answer), and refuses invalid collisions.
template <class Solve>
[[nodiscard]] Session session_of(Solve solve) {
  return [solve = std::move(solve)](std::span<const Collision> collisions) mutable {
    std::vector<Answer> answers;
    answers.reserve(collisions.size());
    for (const Collision& collision : collisions) {
      const std::vector<Defect> defects = validate(collision);
      answers.push_back(defects.empty() ? Answer{solve(collision)} : Answer{Refused{describe(defects)}});
    }
    return answers;
  };
}

}  // namespace carom::subjects
