// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// The families of friction. They place the impulse that a law would give without the friction cone inside, on or
/// outside this cone.
namespace carom::properties {

/// Sets μ, mostly below 1, and the tangential restitution e_t.
void set_friction(Stream& stream, Collision& collision);

/// The μ at which the impulse of the law `rough`, before the cone limits it, lies on the cone's surface, rounded. It is
/// 1 if there is no such μ. This impulse is (1 + ε) times the normal impulse that stops the approach, plus (1 + e_t)
/// times the impulse that then stops the contact point.
[[nodiscard]] double critical_friction(const Collision& collision);

/// The μ at which the impulse of the law `sticking` lies on the cone's surface, rounded; 1 if there is no such μ. This
/// impulse leaves the contact point only the normal velocity −ε N·V⁻. Below this μ the law `coulomb` slips.
[[nodiscard]] double friction_that_sticks(const Collision& collision);

[[nodiscard]] Case sticking(Stream& stream);
[[nodiscard]] Case sliding(Stream& stream);
[[nodiscard]] Case on_the_cone(Stream& stream);
[[nodiscard]] Case stick_or_slip(Stream& stream);
[[nodiscard]] Case no_friction(Stream& stream);
[[nodiscard]] Case great_friction(Stream& stream);
[[nodiscard]] Case spin_alone(Stream& stream);
[[nodiscard]] Case special_tangential_restitution(Stream& stream);

}  // namespace carom::properties
