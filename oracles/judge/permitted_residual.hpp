// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/judge/permitted_inputs.hpp>
#include <carom/oracles/laws/equations.hpp>

namespace carom::oracles {

/// An upper bound of the residual that permitted inputs (permitted_inputs.hpp) and outputs cause beyond their first
/// order. It encloses the products that contain a lever arm. It is 0 for an equation without a lever arm. `after` is
/// the outcome. Each of its vectors is perturbed by ulps of the length in `sizes`. Precondition: that of the equation.
[[nodiscard]] double permitted_residual(const Equation& equation, const PermittedInputs& inputs,
                                        const Collision& collision, const Outcome<double>& after,
                                        const PerVector<double>& sizes);

/// The same bound for V⁺ − V⁻ = C F with a fixed matrix C. F is computed from the velocity change of A or of B.
[[nodiscard]] double permitted_residual_of_change(const Matrix3<double>& matrix, bool read_off_a,
                                                  const PermittedInputs& inputs, const Collision& collision,
                                                  const Outcome<double>& after, const PerVector<double>& sizes);

}  // namespace carom::oracles
