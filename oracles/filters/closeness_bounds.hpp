// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/filters/moderate.hpp>

/// Why an outcome that is close to the truth keeps a law, in inequalities (docs/internals/bounds.md). Of a law g,
/// affine in the outcome or convex, s_k = ‖∂g/∂ŷ_k‖ are the slopes at ŷ, ŝ_k the same as binary64 computes them, e_k =
/// ‖ŷ_k − y_k‖ the errors, σ_k = ‖ŷ_k‖ + ‖y_k⁻‖ the sizes, and a the allowance. The judge asks whether what is missed
/// of g is at most a times the scale, of which Σ_k ŝ_k σ_k, as computed, is a part.
///
///   (1) g(y) = 0, or g(y) ≤ 0, so what is missed of g(ŷ) is at most Σ_k s_k e_k;
///   (2) e_k ≤ (1 − m) a σ_k where a vector is close, m = 2⁻²⁰ being set aside;
///   (3) |ŝ_k − s_k| ≤ 2⁻⁴⁰ s_k: s_k is a length of N, m, r, J or of their products, without cancellation;
///   (4) but for r × N, where |ŝ_k − s_k| ≤ 2⁻⁴⁶ t_k, t_k = ‖r‖ ‖N‖, and for ∂E/∂ŷ, where it is ≤ 2⁻⁴⁰ t_k, t_k =
///       m (σ_k + the wall's speed) or max I σ_k: with N the sum of these times σ_k, N ≤ 2⁻²¹ Σ_k ŝ_k σ_k is asked for;
///   (5) Σ_k s_k e_k ≤ (1 − m) a Σ_k s_k σ_k ≤ a Σ_k ŝ_k σ_k, both sums as computed: (1 − m) times 1 + 2⁻⁴⁰ + 2⁻²¹ and
///       the roundings is at most 1;
///   (6) where e_k > 0 the part is a number that the judge takes: least slope (moderate.hpp) × least size ≥ 2⁻⁹⁰⁰.
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

/// Of the energy, whose slopes have no least: what the scale has to be itself.
inline constexpr double least_scale_of_energy = 0x1p-800;

}  // namespace carom::oracles::closeness_bounds
