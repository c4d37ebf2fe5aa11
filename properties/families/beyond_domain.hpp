// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// Families beyond the domain that solvers claim: they show where a method stops.
namespace carom::properties {

/// At most so large is κ(K): 1 + tr(Σ [r]ᵀ J⁻¹ [r]) / λ, since λI ⪯ K. Of two immovable bodies 1.
[[nodiscard]] double condition_number_at_most(const Collision& collision);

/// The greatest moment of a body over the sum of its two others, of the body where that is more. No distribution of
/// mass has more than 1. Of immovable bodies 0.
[[nodiscard]] double moment_excess(const Collision& collision);

/// One of the moments becomes `excess` times the sum of the two others, which share it.
void set_moment_excess(Stream& stream, Body& body, double excess);

/// Moves the body so that the contact is as close to its centre of mass as its least moment asks for: K then has a
/// bound.
void strike_close(Stream& stream, const Collision& collision, Body& body);

/// The contact lies far outside of one body or of both.
[[nodiscard]] Case far_contacts(Stream& stream);

/// Of one body or of both, one moment exceeds the sum of the two others.
[[nodiscard]] Case impossible_moments(Stream& stream);

}  // namespace carom::properties
