// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <carom/properties/families/family.hpp>
#include <carom/properties/families/sweep.hpp>
#include <carom/properties/gate/workers.hpp>
#include <carom/report/chart/measurement.hpp>
#include <carom/subjects/methods.hpp>

namespace carom::tool::chart {

/// The first `count` colliding collisions of a family; fewer where the family has none in a long row.
[[nodiscard]] std::vector<Collision> colliding_cases(const properties::Family& family, std::uint64_t seed,
                                                     std::size_t count);

/// The same at one quantity of a sweep.
[[nodiscard]] std::vector<Collision> colliding_cases(const properties::Sweep& sweep, double quantity,
                                                     std::uint64_t seed, std::size_t count);

/// To find all answers of the law `coulomb` takes some milliseconds a case; its equations say whether one is lawful,
/// and not how many digits it has.
enum class AnswersOfCoulomb { found, left_out };

/// How exact each method is on the same colliding collisions, judged against the exact truth, or the equations
/// of a law that has none and the nearest of its answers: one for each method, without the cases that its precision
/// cannot hold, or of which nothing is asked. So many threads at once.
[[nodiscard]] std::vector<report::Exactness> measured_exactness(std::span<const subjects::Method> methods,
                                                                std::span<const Collision> collisions,
                                                                double limit_ulps, const properties::Workers& workers,
                                                                AnswersOfCoulomb answers_of_coulomb);

}  // namespace carom::tool::chart
