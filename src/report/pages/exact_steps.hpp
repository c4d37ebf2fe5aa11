// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/judge/exact_case.hpp>

/// The exact outcome of a collision as text, a line for each step.
namespace carom::report {

[[nodiscard]] const char* in_words_of(oracles::Approach approach);

/// The steps that are the same under every law: lever arms, relative velocity, and the collision matrix.
[[nodiscard]] std::string contact_steps(const oracles::ExactCase& exact_case);

/// The impulse and the outcome under the law. Precondition: the law determines one outcome.
[[nodiscard]] std::string truth_steps(const oracles::ExactCase& exact_case, Law law);

/// All answers of the law `coulomb`.
[[nodiscard]] std::string answers_steps(const oracles::ExactCase& exact_case,
                                        const std::vector<oracles::CoulombAnswer>& answers);

}  // namespace carom::report
