// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>
#include <carom/collision/model.hpp>

namespace carom::fuzz {

/// Whether Carom's solvers of the law in double claim to be sound on this collision, whose numbers follow no family:
/// they are moderate (carom/oracles/filters/moderate.hpp); no body is more slender than those of the family
/// `physical`; and, for laws that invert K, K ⪯ 16 λI, as of bodies of uniform density that are star-shaped from the
/// contact point, convex ones among them (the README and docs/findings/accuracy.md say what happens beyond).
/// Precondition: the collision is valid.
[[nodiscard]] bool is_in_claimed_domain(const Collision& collision, Model model);

}  // namespace carom::fuzz
