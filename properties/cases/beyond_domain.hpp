// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/cases/family.hpp>

/// Families beyond the domain that solvers claim. They show the limits of a method.
namespace carom::properties {

/// An upper bound of the condition number κ(K) of the collision matrix K = λI + M, with λ = 1/m_A + 1/m_B and M = Σ
/// [r]ᵀ J⁻¹ [r]. As λI ⪯ K ⪯ (λ + tr M) I, the bound is 1 + tr(M) / λ. It is 1 for two immovable bodies.
[[nodiscard]] double condition_number_at_most(const Collision& collision);

/// For each body, the greatest principal moment divided by the sum of the others; the greater of both quotients. At
/// most 1 for real bodies. An immovable body counts as 0.
[[nodiscard]] double moment_excess(const Collision& collision);

/// The greatest principal moment of a body over its least; the greater of both bodies' quotients. An immovable body
/// counts as 0.
[[nodiscard]] double greatest_moment_ratio(const Collision& collision);

/// Whether `collision` is no further beyond the domain that solvers claim than `other`. Three measures decide: the
/// excess of moments of each body, the ratio of its greatest moment to its least, and `condition_number_at_most`. Each
/// must be at most the measure of `other`, or at most a fixed limit: 1, 8 and 46.
[[nodiscard]] bool is_no_further_beyond_domain(const Collision& collision, const Collision& other);

/// Sets the moments so that one of them is `excess` times the sum of the others.
void set_moment_excess(Stream& stream, Body& body, double excess);

/// Moves the body so that the contact lies within √(I/m) of its centre of mass, with the least moment I. This bounds
/// κ(K).
void strike_close(Stream& stream, const Collision& collision, Body& body);

/// The contact lies far outside one body or both.
[[nodiscard]] Case far_contacts(Stream& stream);

/// One body or both have a moment that is at least the sum of the others.
[[nodiscard]] Case impossible_moments(Stream& stream);

/// A convex body of uniform density, 10 to 10⁶ times as long as wide, that is struck on its tip along its long axis.
/// The other body is immovable, a second such needle, or any convex body of uniform density.
///
/// The angle between N and the long axis is zero or 10^-k, with k = 1 to 18. Likewise, the tangential part of V⁻ is
/// zero or 10^-k times the normal part. So lever arm, impulse and long axis are nearly parallel, and the torque is the
/// small difference of large products.
[[nodiscard]] Case needle_tip(Stream& stream);

}  // namespace carom::properties
