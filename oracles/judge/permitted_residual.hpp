// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/judge/permitted_inputs.hpp>
#include <carom/oracles/laws/equations.hpp>

namespace carom::oracles {

/// The residual of permitted inputs and outputs beyond their first order: an enclosure of the products that contain a
/// lever arm. It is 0 for an equation without a lever arm. `after` is the outcome. `sizes` are the lengths of its
/// vectors, and each vector is perturbed by ulps of its length. Precondition: the equation applies to this collision.
[[nodiscard]] double permitted_residual(const Equation& equation, const PermittedInputs& inputs,
                                        const Collision& collision, const Outcome<double>& after,
                                        const PerVector<double>& sizes);

/// The residual of V⁺ − V⁻ = C F, for a matrix C that stays fixed. F is computed from the velocity change of A or of B.
[[nodiscard]] double permitted_residual_of_change(const Matrix3<double>& matrix, bool read_off_a,
                                                  const PermittedInputs& inputs, const Collision& collision,
                                                  const Outcome<double>& after, const PerVector<double>& sizes);

}  // namespace carom::oracles
