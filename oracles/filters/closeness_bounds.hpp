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
///   (1) g(y) = 0, or g(y) ≤ 0. So the residual of g(ŷ) is at most Σ_k s_k e_k.
///   (2) Vector k is close if e_k ≤ (1 − h) α σ_k. The share h = 2⁻²⁰ is set aside for rounding.
///   (3) Most slopes are lengths of N, m, r, J or of their products. Their error |ŝ_k − s_k| is at most 2⁻⁴⁰ s_k.
///   (4) Other slopes may cancel. The error of ‖r × N‖ is at most 2⁻⁴⁶ t_k with t_k = ‖r‖ ‖N‖. For the energy, the
///       error is at most 2⁻⁴⁰ t_k, with t_k = m (σ_k + the wall's speed) for a velocity and t_k = max I σ_k for an
///       angular velocity. The noise is the sum of these errors times σ_k. It must be at most 2⁻²¹ Σ_k ŝ_k σ_k.
///   (5) Σ_k s_k e_k ≤ (1 − h) α Σ_k s_k σ_k ≤ α Σ_k ŝ_k σ_k. The computed sums satisfy this too, because
///       (1 − h) (1 + 2⁻⁴⁰ + 2⁻²¹) times their roundings is at most 1.
///   (6) `compare` takes a sum Σ_k ŝ_k σ_k of at least 2⁻⁹⁰⁰. If e_k > 0, the sum is that large, because
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

/// The least Σ_k ŝ_k σ_k that closeness accepts for the energy, because (6) does not apply to its slopes.
inline constexpr double least_scale_of_energy = 0x1p-899;

}  // namespace carom::oracles::closeness_bounds
