// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// Families beyond the domain that solvers claim. They show the limits of a method.
namespace carom::properties {

/// An upper bound of κ(K): 1 + tr(Σ [r]ᵀ J⁻¹ [r]) / λ, because λI ⪯ K. 1 for two immovable bodies.
[[nodiscard]] double condition_number_at_most(const Collision& collision);

/// The greatest moment of a body over the sum of its two others; the greater value of the two bodies. No distribution
/// of mass has more than 1. 0 for immovable bodies.
[[nodiscard]] double moment_excess(const Collision& collision);

/// Sets the body's moments so that one of them is `excess` times the sum of the two others.
void set_moment_excess(Stream& stream, Body& body, double excess);

/// Moves the body so that the contact lies within √(I/m) of its centre of mass, with I its least moment. This bounds
/// κ(K).
void strike_close(Stream& stream, const Collision& collision, Body& body);

/// A case whose contact lies far outside one body or both.
[[nodiscard]] Case far_contacts(Stream& stream);

/// A case in which one moment of a body, or of both, is at least the sum of the two others.
[[nodiscard]] Case impossible_moments(Stream& stream);

}  // namespace carom::properties
