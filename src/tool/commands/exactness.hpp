// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <carom/properties/cases/family.hpp>
#include <carom/properties/cases/sweep.hpp>
#include <carom/properties/gate/workers.hpp>
#include <carom/report/pictures/measurement.hpp>

#include "commands/charted_subjects.hpp"

namespace carom::tool::chart {

/// The first `count` colliding collisions of a family. There are fewer if less than one case in 20 collides.
[[nodiscard]] std::vector<Collision> colliding_cases(const properties::Family& family, std::uint64_t seed,
                                                     std::size_t count);

/// The first `count` colliding collisions of a sweep whose quantity has this value. There are fewer if less than one
/// case in 20 collides.
[[nodiscard]] std::vector<Collision> colliding_cases(const properties::Sweep& sweep, double quantity,
                                                     std::uint64_t seed, std::size_t count);

/// Whether to compute all answers of the law `coulomb`, which takes some milliseconds a case. Without them, the law's
/// equations still judge an outcome, but the number of its correct digits is unknown.
enum class AnswersOfCoulomb { found, left_out };

/// The accuracy of each subject on these colliding collisions, in the order of the subjects. The truth (the exact
/// outcome) judges an outcome, after the effects that the subject declares are taken out. Under `coulomb`, which may
/// have several answers, the law's equations judge the outcome, and the nearest answer gives its digits. A case is left
/// out if the subject's precision cannot represent it, if the law demands nothing of its outcome, or if it does not
/// collide because of a declared effect. Precondition: each subject has a law.
[[nodiscard]] std::vector<report::Exactness> measured_exactness(ChartedSubjects& charted,
                                                                std::span<const Collision> collisions,
                                                                double limit_ulps, const properties::Workers& workers,
                                                                AnswersOfCoulomb answers_of_coulomb);

}  // namespace carom::tool::chart
