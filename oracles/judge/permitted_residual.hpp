// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/judge/permitted_inputs.hpp>
#include <carom/oracles/laws/equations.hpp>

namespace carom::oracles {

/// An upper bound of the residual that arises through products with a lever arm if inputs and outputs move. The inputs
/// stay permitted (permitted_inputs.hpp). Vector k of the outcome `after` moves by at most the allowance times
/// sizes[k]. `compare` permits this residual in addition to the allowance times the scale. Precondition: that of the
/// equation.
[[nodiscard]] double permitted_residual(const Equation& equation, const PermittedInputs& inputs,
                                        const Collision& collision, const Outcome<double>& after,
                                        const PerVector<double>& sizes);

/// The same bound for V⁺ − V⁻ = C F with a fixed matrix C. F is computed from the velocity change of A or of B.
[[nodiscard]] double permitted_residual_of_change(const Matrix3<double>& matrix, bool read_off_a,
                                                  const PermittedInputs& inputs, const Collision& collision,
                                                  const Outcome<double>& after, const PerVector<double>& sizes);

}  // namespace carom::oracles
