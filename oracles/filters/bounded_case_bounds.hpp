// SPDX-License-Identifier: BSL-1.0
#pragma once

/// What bounds decide of a case, in inequalities (docs/internals/bounds.md). u = 2⁻⁵³.
namespace carom::oracles::bounded_case_bounds {

/// N·V⁻ in binary64. With S at least the sum of the sizes of its terms:
///
///   (1) |v̂ − N·V⁻| ≤ n u / (1 − n u) S, n the roundings of a term;
///   (2) where |v̂| > 2⁻²⁸ S it is known to 10⁻⁶ of itself, and its sign.
inline constexpr int roundings_of_normal_velocity = 8;
inline constexpr double known_share_of_normal_velocity = 0x1p-28;

/// The same of an enclosure, by its radius.
inline constexpr double known_radius_of_normal_velocity = 0x1p-20;

/// The judge asks whether |v̂| ≤ a Ŝ, for a sum Ŝ of absolute values of at most S. Both are rounded by less than a
/// quarter, so that it is not where |v̂| > 2 a S as computed.
inline constexpr double factor_for_grazing = 2;

/// The lower bound of the collision matrix's sensitivity Σ_q ‖∂K/∂q‖ ‖q‖, of which the judge has the sum Ŝ as
/// binary64 computes it. With T the sum of ‖r‖² / min I over the movable bodies:
///
///   (1) the exact sum over masses and moments alone is at least ‖K‖_F, for K is of degree −1 in them (Euler), and that
///       over masses alone at least λ;
///   (2) Ŝ ≥ (1 − 2⁻⁴⁰) (that sum − c u T), c = `roundings_of_matrix_sensitivity`;
///   (3) where ‖K‖_F ≥ 2⁻²⁰ T: ‖K‖_F − c u T ≥ ‖K‖_F / 2, and a little; λ / 2 everywhere.
inline constexpr double roundings_of_matrix_sensitivity = 0x1p+16;
inline constexpr double least_share_of_largest_terms = 0x1p-20;

/// On the cone's surface the law `rough` divides by q = ‖N × D‖ − μ N·D. Of a moderate collision Σ_q ‖∂y_k/∂q‖ ‖q‖
/// is at most 2⁶⁶⁰ where q is left as it is, and ‖D‖ / q adds no more than ‖K‖ / λ ≤ 2²⁶⁰ over this share of its terms:
/// it is finite.
inline constexpr double least_share_of_divisor = 0x1p-40;

}  // namespace carom::oracles::bounded_case_bounds
