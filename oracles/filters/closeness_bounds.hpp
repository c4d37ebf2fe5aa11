// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/filters/moderate.hpp>

/// Inequalities that show why an outcome ŷ close to the truth y satisfies an equation g (closeness.hpp,
/// docs/internals/bounds.md). g is affine in the outcome, or convex. For each vector k of the outcome:
///
///   s_k = ‖∂g/∂ŷ_k‖ is the slope of g at ŷ, and ŝ_k is the slope as computed in binary64;
///   e_k = ‖ŷ_k − y_k‖ is the error;
///   σ_k = ‖ŷ_k‖ + ‖y_k⁻‖ is the size, with y_k⁻ the vector before the impulse.
///
/// The computed sum Σ_k ŝ_k σ_k is a part of the scale of g (yardstick.hpp). So g holds if its residual is at most the
/// allowance α times this sum.
///
///   (1) The truth has g(y) = 0, or g(y) ≤ 0 for an inequality. So the residual of g at ŷ is at most Σ_k s_k e_k.
///   (2) Vector k is close if e_k ≤ (1 − h) α σ_k. The share h = 2⁻²⁰ is set aside for rounding.
///   (3) Most slopes are norms of N, m, r, J or of products of these. For such a slope, |ŝ_k − s_k| ≤ 2⁻⁴⁰ s_k.
///   (4) In other slopes, terms may cancel. For ‖r × N‖, |ŝ_k − s_k| ≤ 2⁻⁴⁶ t_k with t_k = ‖r‖ ‖N‖. For the energy,
///       |ŝ_k − s_k| ≤ 2⁻⁴⁰ t_k. There, t_k is m (σ_k + the wall's speed) for a velocity, and max I σ_k for an angular
///       velocity. The noise, the sum of these bounds times σ_k, must be at most 2⁻²¹ Σ_k ŝ_k σ_k.
///   (5) By (2) to (4), Σ_k s_k e_k ≤ (1 − h) α Σ_k s_k σ_k ≤ α Σ_k ŝ_k σ_k. The computed sums satisfy this, too,
///       because (1 − h) (1 + 2⁻⁴⁰ + 2⁻²¹), times the roundings of these sums, is at most 1.
///   (6) `compare` uses Σ_k ŝ_k σ_k only if this sum is at least 2⁻⁹⁰⁰. If some e_k > 0, the sum is at least
///       `least_slope_of_moderate` × `least_size` ≥ 2⁻⁹⁰⁰.
namespace carom::oracles::closeness_bounds {

/// h of (2).
inline constexpr double set_aside = 0x1p-20;

/// The relative error of a slope in (3).
inline constexpr double rounding_of_slope = 0x1p-40;

/// The errors of slopes in (4), and the limit of the noise.
inline constexpr double noise_of_moment = 0x1p-46;
inline constexpr double noise_of_energy_slope = 0x1p-40;
inline constexpr double share_for_noise = 0x1p-21;

/// The least size σ_k of (6).
inline constexpr double least_size = 0x1p-620;

/// The least Σ_k ŝ_k σ_k that closeness accepts for the energy, because (6) does not hold for the slopes of the energy.
inline constexpr double least_scale_of_energy = 0x1p-899;

}  // namespace carom::oracles::closeness_bounds
