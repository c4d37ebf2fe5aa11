// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// Families beyond the domain that solvers claim. They show the limits of a method.
namespace carom::properties {

/// An upper bound of the condition number κ(K) of the collision matrix K = λI + Σ [r]ᵀ J⁻¹ [r], with λ = 1/m_A + 1/m_B.
/// As λI ⪯ K, the bound is 1 + tr(Σ [r]ᵀ J⁻¹ [r]) / λ. It is 1 for two immovable bodies.
[[nodiscard]] double condition_number_at_most(const Collision& collision);

/// The greatest principal moment of a body divided by the sum of the others, for the body with the greater quotient.
/// For a real body it is at most 1. An immovable body counts as 0.
[[nodiscard]] double moment_excess(const Collision& collision);

/// Whether a collision is no further beyond the domain that solvers claim than `other`, by three measures. Each measure
/// must be at most that of `other`, or at most a free limit. The excess of moments of a body is free up to 1, the ratio
/// of its greatest moment to its least up to 8, and `condition_number_at_most` up to 46.
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

}  // namespace carom::properties
