// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/filters/moderate.hpp>

/// Inequalities that show why an outcome close to the truth keeps a law (docs/internals/bounds.md). The law g is affine
/// in the outcome or convex. The slopes at ŷ are s_k = ‖∂g/∂ŷ_k‖, and ŝ_k as binary64 computes them. The errors are e_k
/// = ‖ŷ_k − y_k‖, the sizes are σ_k = ‖ŷ_k‖ + ‖y_k⁻‖, and a is the allowance. The judge requires the residual of g to
/// be at most a times the scale. The computed Σ_k ŝ_k σ_k is a part of the scale.
///
///   (1) g(y) = 0, or g(y) ≤ 0, so the residual of g(ŷ) is at most Σ_k s_k e_k.
///   (2) e_k ≤ (1 − m) a σ_k if a vector is close. m = 2⁻²⁰ is set aside.
///   (3) |ŝ_k − s_k| ≤ 2⁻⁴⁰ s_k: s_k is a length of N, m, r, J or of their products, without cancellation.
///   (4) There are two exceptions. For r × N, |ŝ_k − s_k| ≤ 2⁻⁴⁶ t_k with t_k = ‖r‖ ‖N‖. For ∂E/∂ŷ, the same error is
///       at most 2⁻⁴⁰ t_k with t_k = m (σ_k + the wall's speed) or max I σ_k. N is the sum of these errors times σ_k.
///       Closeness requires N ≤ 2⁻²¹ Σ_k ŝ_k σ_k.
///   (5) Σ_k s_k e_k ≤ (1 − m) a Σ_k s_k σ_k ≤ a Σ_k ŝ_k σ_k, both sums as computed: (1 − m) times 1 + 2⁻⁴⁰ + 2⁻²¹ and
///       the roundings is at most 1.
///   (6) If e_k > 0, the judge accepts the part as a scale: least slope (moderate.hpp) × least size ≥ 2⁻⁹⁰⁰.
namespace carom::oracles::closeness_bounds {

/// m of (2).
inline constexpr double set_aside = 0x1p-20;

/// (3).
inline constexpr double rounding_of_slope = 0x1p-40;

/// (4).
inline constexpr double noise_of_moment = 0x1p-46;
inline constexpr double noise_of_energy_slope = 0x1p-40;
inline constexpr double share_for_noise = 0x1p-21;

/// (6).
inline constexpr double least_size = 0x1p-500;

/// The least scale of the energy itself, because its slopes have no lower bound.
inline constexpr double least_scale_of_energy = 0x1p-800;

}  // namespace carom::oracles::closeness_bounds
