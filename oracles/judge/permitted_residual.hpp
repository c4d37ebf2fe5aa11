// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/judge/permitted_inputs.hpp>
#include <carom/oracles/laws/equations.hpp>

namespace carom::oracles {

/// The residual that permitted inputs and outputs can have beyond their first order: the products in which a lever arm
/// takes part, enclosed. It is 0 for an equation that no lever arm enters. `after` is the outcome. `sizes` are the
/// lengths by ulps of which its vectors are perturbed. Precondition: the equation speaks of this collision.
[[nodiscard]] double permitted_residual(const Equation& equation, const PermittedInputs& inputs,
                                        const Collision& collision, const Outcome<double>& after,
                                        const PerVector<double>& sizes);

/// The same of V⁺ − V⁻ = C F, for a matrix C that is held fast. F is read off A or off B.
[[nodiscard]] double permitted_residual_of_change(const Matrix3<double>& matrix, bool read_off_a,
                                                  const PermittedInputs& inputs, const Collision& collision,
                                                  const Outcome<double>& after, const PerVector<double>& sizes);

}  // namespace carom::oracles
