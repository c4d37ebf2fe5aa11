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

/// The first `count` colliding collisions of a family. There are fewer if less than one case in 20 collides.
[[nodiscard]] std::vector<Collision> colliding_cases(const properties::Family& family, std::uint64_t seed,
                                                     std::size_t count);

/// The first `count` colliding collisions of a sweep with its quantity set to this value. There are fewer if less than
/// one case in 20 collides.
[[nodiscard]] std::vector<Collision> colliding_cases(const properties::Sweep& sweep, double quantity,
                                                     std::uint64_t seed, std::size_t count);

/// Whether all answers of the law `coulomb` are found, in some milliseconds a case. Without them, the law's equations
/// decide if an outcome is lawful, but the number of its correct digits is unknown.
enum class AnswersOfCoulomb { found, left_out };

/// The accuracy of each method on the same colliding collisions, one entry for each method. An outcome is judged
/// against the exact truth. An outcome of a law with several answers is judged by the law's equations, and compared
/// with the nearest answer. A case that the method's precision cannot represent, or about which the law demands
/// nothing, is left out. Runs on `workers`.
[[nodiscard]] std::vector<report::Exactness> measured_exactness(std::span<const subjects::Method> methods,
                                                                std::span<const Collision> collisions,
                                                                double limit_ulps, const properties::Workers& workers,
                                                                AnswersOfCoulomb answers_of_coulomb);

}  // namespace carom::tool::chart
