// SPDX-License-Identifier: BSL-1.0
#pragma once

/// The inequalities by which BoundedCase decides facts about a collision (docs/internals/bounds.md). u = 2⁻⁵³.
namespace carom::oracles::bounded_case_bounds {

/// v̂ is N·V⁻ as computed in binary64. S is at least the sum of the absolute values of the terms of N·V⁻:
///
///   (1) |v̂ − N·V⁻| ≤ n u / (1 − n u) S, with n the number of roundings of a term;
///   (2) if |v̂| > 2⁻²⁸ S, its relative error is at most 10⁻⁶, and its sign is known.
inline constexpr int roundings_of_normal_velocity = 8;
inline constexpr double known_share_of_normal_velocity = 0x1p-28;

/// The limit for an `Enclosure` of N·V⁻, as the ratio of its radius to its size.
inline constexpr double known_radius_of_normal_velocity = 0x1p-20;

/// `ExactCase::is_grazing` compares |v̂| with a Ŝ. a is the allowance, and Ŝ the computed sensitivity of N·V⁻. The
/// exact sensitivity is at most S. Ŝ and S as computed have relative errors of less than a quarter. So |v̂| > a Ŝ if
/// |v̂| > 2 a S as computed.
inline constexpr double factor_for_grazing = 2;

/// A lower bound of the collision matrix's sensitivity Σ_q ‖∂K/∂q‖ ‖q‖. The judge computes this sum in binary64, as Ŝ.
/// T is the sum of ‖r‖² / min I over the movable bodies:
///
///   (1) The exact sum over masses and moments alone is at least ‖K‖_F, because K is homogeneous of degree −1 in them
///       (Euler). The sum over masses alone is at least λ.
///   (2) Ŝ ≥ (1 − 2⁻⁴⁰) (the exact sum − c u T), with c = `roundings_of_matrix_sensitivity`.
///   (3) If ‖K‖_F ≥ 2⁻²⁰ T, then ‖K‖_F − c u T is at least ¾ ‖K‖_F, so Ŝ exceeds ‖K‖_F / 2. The bound λ / 2 always
///       holds.
inline constexpr double roundings_of_matrix_sensitivity = 0x1p+16;
inline constexpr double least_share_of_largest_terms = 0x1p-20;

/// On the cone's surface, the law `rough` (models/rough.hpp) divides by d = ‖N × D‖ − μ N·D. For a moderate collision,
/// Σ_q ‖∂y_k/∂q‖ ‖q‖ is at most 2⁶⁶⁰ without this division. If d is at least this share of the sum of its terms, the
/// division adds a factor ‖D‖ / d. This factor is at most ‖K‖ / λ ≤ 2²⁶⁰ divided by the share. So the sum is finite.
inline constexpr double least_share_of_divisor = 0x1p-40;

}  // namespace carom::oracles::bounded_case_bounds
