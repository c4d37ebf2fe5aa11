// SPDX-License-Identifier: BSL-1.0
#pragma once

/// The inequalities by which ExactCase decides facts about a collision (docs/internals/bounds.md). u = 2⁻⁵³.
namespace carom::oracles::exact_case_bounds {

/// An `Enclosure` of N·V⁻ has six digits if its radius is below this share of |N·V⁻|.
inline constexpr double known_radius_of_normal_velocity = 0x1p-20;

/// A lower bound of the sensitivity Q = Σ_q ‖∂K/∂q‖ ‖q‖ of the collision matrix K. Q̂ is Q as the judge computes it in
/// binary64, and T is the sum of ‖r‖² / min I over the movable bodies:
///
///   (1) K is homogeneous of degree −1 in the masses and moments. So the masses and moments contribute at least ‖K‖_F
///       to Q (Euler). The masses alone contribute at least λ = 1/m_A + 1/m_B.
///   (2) Q̂ ≥ (1 − 2⁻⁴⁰) (Q − c u T), with c = `roundings_of_matrix_sensitivity`.
///   (3) If ‖K‖_F ≥ 2⁻²⁰ T, then ‖K‖_F − c u T is at least ¾ ‖K‖_F, so Q̂ exceeds ‖K‖_F / 2. Q̂ ≥ λ / 2 always holds.
inline constexpr double roundings_of_matrix_sensitivity = 0x1p+16;
inline constexpr double least_share_of_largest_terms = 0x1p-20;

/// On the cone's surface, the law `rough` (models/rough.hpp) divides by d = ‖N × D‖ − μ N·D. Without this division,
/// Σ_q ‖∂y_k/∂q‖ ‖q‖ of a moderate collision is at most 2⁶⁶⁰. If d is at least this share of ‖N × D‖ + μ |N·D|, the
/// division multiplies the sum by at most ‖D‖ / d ≤ 2⁴⁰ ‖K‖ / λ ≤ 2³⁰⁰. So the sum is finite.
inline constexpr double least_share_of_divisor = 0x1p-40;

}  // namespace carom::oracles::exact_case_bounds
