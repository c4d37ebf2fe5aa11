// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// The families of friction: where the impulse that would do all of what a law asks for lies to the cone.
namespace carom::properties {

/// Sets μ, mostly below 1, and e_t.
void set_friction(Stream& stream, Collision& collision);

/// The μ at which that impulse lies on the cone's surface, rounded; 1 where there is none.
[[nodiscard]] double critical_friction(const Collision& collision);

/// The μ at which the impulse that stops the contact point, but for ε, lies on the cone's surface, rounded; 1 where
/// there is none. Below it the law `coulomb` slips.
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
