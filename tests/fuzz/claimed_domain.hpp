// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>
#include <carom/collision/law.hpp>

namespace carom::fuzz {

/// Whether Carom's binary64 solvers of the law claim to be sound on a collision that no family drew. The collision's
/// numbers must be moderate (carom/oracles/filters/moderate.hpp). No body may be more slender than those of the family
/// `physical`. Laws that invert the collision matrix K also require K ⪯ 16 λI, with λ = 1/m_A + 1/m_B. This bound holds
/// for bodies of uniform density that are star-shaped from the contact point, such as convex bodies. Precondition: the
/// collision is valid.
[[nodiscard]] bool is_in_claimed_domain(const Collision& collision, Law law);

}  // namespace carom::fuzz
