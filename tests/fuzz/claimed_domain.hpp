// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>
#include <carom/collision/law.hpp>

namespace carom::fuzz {

/// Whether Carom's solvers of the law in double claim to be sound on this collision, which no family drew. Its numbers
/// must be moderate in size (carom/oracles/filters/moderate.hpp), and no body may be more slender than those of the
/// family `physical`. Laws that invert the collision matrix K also require K ⪯ 16 λI, with λ = 1/m_A + 1/m_B. This
/// holds for bodies of uniform density that are star-shaped from the contact point, such as convex bodies. The pages
/// accuracy.md of docs/findings and docs/reference describe the behaviour beyond this domain. Precondition: the
/// collision is valid.
[[nodiscard]] bool is_in_claimed_domain(const Collision& collision, Law law);

}  // namespace carom::fuzz
