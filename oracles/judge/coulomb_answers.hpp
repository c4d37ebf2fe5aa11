// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/models/coulomb.hpp>

namespace carom::oracles {

/// All answers of the law `coulomb` to a case: the velocities as they are where it does not collide.
[[nodiscard]] std::vector<CoulombAnswer> coulomb_answers(const ExactCase& exact_case);

/// Which of the answers an outcome is nearest to, and how near.
struct NearestAnswer {
  std::size_t number;  // of the answer, from 0
  double digits;       // correct ones of the change of the velocities, as Accuracy::digits
};

/// Preconditions: the answers are those of the case, and the outcome is finite.
[[nodiscard]] NearestAnswer nearest_answer(const ExactCase& exact_case, const std::vector<CoulombAnswer>& answers,
                                           const Outcome<long double>& outcome);

}  // namespace carom::oracles
