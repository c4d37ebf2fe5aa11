// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <initializer_list>

#include <carom/oracles/truths/sensitivity.hpp>

/// The parts of a sensitivity of second order (ExactCase::sensitivity). A part beyond the range of numbers is 0.
namespace carom::oracles {

/// ‖y_k⁻‖ plus the largest change of vector k by an impulse of length 2 s / λ, with s ≥ ‖V⁻‖.
[[nodiscard]] Sensitivity second_order(const Collision& collision);

/// The largest changes by [δr]ᵀ J⁻¹ [δr], the change of K of second order, for an impulse that is the sum of these. The
/// first order vanishes if r × N = 0. Precondition: a body is movable.
[[nodiscard]] Sensitivity second_order_of_arms(const Collision& collision,
                                               std::initializer_list<Vector3<double>> impulses);

/// The largest changes by an impulse that rounding alone causes, and by the first-order change of K. It matters if the
/// contact grazes. `normal_velocity_sensitivity` is Σ_q ‖∂(N·V⁻)/∂q‖ ‖q‖. Precondition: a body is movable.
[[nodiscard]] Sensitivity second_order_from_rest(const Collision& collision, double normal_velocity_sensitivity);

}  // namespace carom::oracles
