// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <carom/oracles/judge/permitted_inputs.hpp>
#include <carom/oracles/laws/equations.hpp>

namespace carom::oracles {

/// By how much the two sides of an equation may miss each other for permitted inputs and outputs, beyond what their
/// derivatives tell: products in which a lever arm takes part, enclosed. 0 of an equation that no lever arm enters.
/// `after` is the outcome, `sizes` the lengths that its vectors are perturbed by. Precondition: the equation speaks of
/// this collision.
[[nodiscard]] double permitted_residual(const Equation& equation, const PermittedInputs& inputs,
                                        const Collision& collision, const Outcome<double>& after,
                                        const PerVector<double>& sizes);

/// The same of V⁺ − V⁻ = C F, for a matrix C that is held fast. F is read off A or off B.
[[nodiscard]] double permitted_residual_of_change(const Matrix3<double>& matrix, bool read_off_a,
                                                  const PermittedInputs& inputs, const Collision& collision,
                                                  const Outcome<double>& after, const PerVector<double>& sizes);

}  // namespace carom::oracles
