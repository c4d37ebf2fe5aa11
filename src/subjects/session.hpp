// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/collision/validate.hpp>

namespace carom::subjects {

/// A session that answers with `solve`, and refuses invalid collisions. `solve` maps a collision to an answer, or
/// writes the outcome of a collision into a ReportedOutcome without a collision matrix.
template <class Solve>
[[nodiscard]] Session session_of(Solve solve) {
  return [solve = std::move(solve)](std::span<const Collision> collisions) mutable {
    std::vector<Answer> answers;
    answers.reserve(collisions.size());
    for (const Collision& collision : collisions) {
      if (const std::vector<InputError> errors = validate(collision); !errors.empty()) {
        answers.emplace_back(Refused{describe(errors)});
      } else if constexpr (std::is_invocable_v<Solve&, const Collision&, ReportedOutcome&>) {
        solve(collision, std::get<ReportedOutcome>(answers.emplace_back()));
      } else {
        answers.emplace_back(solve(collision));
      }
    }
    return answers;
  };
}

}  // namespace carom::subjects
