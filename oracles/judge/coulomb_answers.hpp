// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/truths/coulomb.hpp>

namespace carom::oracles {

/// All answers of the law `coulomb` to the collision of a case. If the case does not collide, the answer is the
/// unchanged velocities.
[[nodiscard]] std::vector<CoulombAnswer> coulomb_answers(const ExactCase& exact_case);

struct NearestAnswer {
  std::size_t number;  // index of the answer, from 0
  double digits;       // correct digits of the change of the velocities (see Accuracy::digits)
};

/// The answer nearest to `outcome`. Preconditions: `answers` come from `coulomb_answers`; the outcome is finite.
[[nodiscard]] NearestAnswer nearest_answer(const ExactCase& exact_case, const std::vector<CoulombAnswer>& answers,
                                           const Outcome<long double>& outcome);

}  // namespace carom::oracles
