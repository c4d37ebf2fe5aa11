// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/truths/coulomb.hpp>

namespace carom::oracles {

/// All answers of the law `coulomb` to the collision of a case. If the case does not collide, the answer is the
/// unchanged velocities.
[[nodiscard]] std::vector<CoulombAnswer> coulomb_answers(const ExactCase& exact_case);

/// Whether the law certainly has one answer to the collision and to all permitted inputs. The function leaves out
/// contacts for which this is hard to show. If a contact collides or grazes, its `friction_feedback` must be at most a
/// half. So it is for spheres, and for each contact whose lever arms are along the normal.
[[nodiscard]] bool has_one_coulomb_answer(const ExactCase& exact_case, double allowance);

/// An upper bound of the sensitivity (sensitivity.hpp) of the only answer. This answer is continuous, also where
/// sticking ends and where the contact grazes. No value if permitted inputs change K too much for first-order bounds.
/// Precondition: has_one_coulomb_answer(exact_case, allowance).
[[nodiscard]] std::optional<Sensitivity> coulomb_sensitivity(const ExactCase& exact_case, double allowance);

/// A cheap lower bound of `coulomb_sensitivity`.
[[nodiscard]] Sensitivity coulomb_sensitivity_below(const ExactCase& exact_case);

struct NearestAnswer {
  std::size_t number;  // index of the answer, from 0
  double digits;       // correct digits of the change of the velocities (see Accuracy::digits)
};

/// The answer nearest to `outcome`. Preconditions: `answers` come from `coulomb_answers`; the outcome is finite.
[[nodiscard]] NearestAnswer nearest_answer(const ExactCase& exact_case, const std::vector<CoulombAnswer>& answers,
                                           const Outcome<long double>& outcome);

}  // namespace carom::oracles
