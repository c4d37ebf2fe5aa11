// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/filters/moderate.hpp>

/// Inequalities that show why an outcome ŷ close to the truth y satisfies an equation g (closeness.hpp,
/// docs/internals/bounds.md). g is affine in the outcome or convex. The slopes at ŷ are s_k = ‖∂g/∂ŷ_k‖, and ŝ_k as
/// binary64 computes them. The errors are e_k = ‖ŷ_k − y_k‖, the sizes are σ_k = ‖ŷ_k‖ + ‖y_k⁻‖, and a is the
/// allowance. y_k⁻ is the vector before the impulse. The judge requires the residual of g to be at most a times the
/// scale (yardstick.hpp). The computed Σ_k ŝ_k σ_k is a part of the scale.
///
///   (1) g(y) = 0, or g(y) ≤ 0, so the residual of g(ŷ) is at most Σ_k s_k e_k.
///   (2) Vector k is close if e_k ≤ (1 − h) a σ_k. h = 2⁻²⁰ is set aside for rounding.
///   (3) |ŝ_k − s_k| ≤ 2⁻⁴⁰ s_k: s_k is a length of N, m, r, J or of their products, without cancellation.
///   (4) There are two exceptions. For r × N, |ŝ_k − s_k| ≤ 2⁻⁴⁶ t_k with t_k = ‖r‖ ‖N‖. For ∂E/∂ŷ, the same error is
///       at most 2⁻⁴⁰ t_k with t_k = m (σ_k + the wall's speed) or max I σ_k. The noise is the sum of these errors
///       times σ_k. Closeness requires that it is at most 2⁻²¹ Σ_k ŝ_k σ_k.
///   (5) Σ_k s_k e_k ≤ (1 − h) a Σ_k s_k σ_k ≤ a Σ_k ŝ_k σ_k. This holds for the computed sums too, because (1 − h) (1
///       + 2⁻⁴⁰ + 2⁻²¹) times the roundings is at most 1.
///   (6) If e_k > 0, the computed sum is large enough for `compare`, because `least_slope_of_moderate` × `least_size` ≥
///       2⁻⁹⁰⁰.
namespace carom::oracles::closeness_bounds {

/// h of (2).
inline constexpr double set_aside = 0x1p-20;

/// (3).
inline constexpr double rounding_of_slope = 0x1p-40;

/// (4).
inline constexpr double noise_of_moment = 0x1p-46;
inline constexpr double noise_of_energy_slope = 0x1p-40;
inline constexpr double share_for_noise = 0x1p-21;

/// (6).
inline constexpr double least_size = 0x1p-500;

/// The least Σ_k ŝ_k σ_k of the energy, because its slopes have no lower bound.
inline constexpr double least_scale_of_energy = 0x1p-800;

}  // namespace carom::oracles::closeness_bounds
