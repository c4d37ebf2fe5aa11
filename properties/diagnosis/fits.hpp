// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <optional>

#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {

/// A number that a solver may have wrong, and that an answer shows.
enum class Fit {
  factor_of_impulse,
  factor_of_spins,  // of the changes of both
  factor_of_spin_of_a,
  factor_of_spin_of_b,
  added_restitution,  // the number that is added to ε
  factor_of_restitution,
  constant_restitution,
  spins_before,        // the factor of both spins in V⁻
  stopped_slip,        // the share of the slip that friction stops
  tangential_part,     // the factor of the impulse across N
  factor_of_friction,  // of μ
  constant_friction,
  length_of_impulse,  // ‖F‖ [N s]
};
inline constexpr std::array all_fits{Fit::factor_of_impulse,    Fit::factor_of_spins,    Fit::factor_of_spin_of_a,
                                     Fit::factor_of_spin_of_b,  Fit::added_restitution,  Fit::factor_of_restitution,
                                     Fit::constant_restitution, Fit::spins_before,       Fit::stopped_slip,
                                     Fit::tangential_part,      Fit::factor_of_friction, Fit::constant_friction,
                                     Fit::length_of_impulse};

/// A fitted number is a fault only if so many cases show it.
inline constexpr std::size_t least_alike = 10;

/// The number with which the steps may give the subject's answer. No value if the answer shows none.
[[nodiscard]] std::optional<double> fitted(Fit fit, const Steps& steps, const KnownCase& one);

/// Whether two fitted numbers are equal within a thousandth.
[[nodiscard]] bool agree(double x, double y);

/// The hypothesis that a solver has this number wrong.
[[nodiscard]] Hypothesis with_number(Fit fit, double number);

/// Whether impulses of this length, along those of the steps, give the subject's answer (`is_explained_by`).
[[nodiscard]] bool gives_answer(const FittedLength& length, const Steps& steps, const KnownCase& one);

}  // namespace carom::properties::diagnosis
