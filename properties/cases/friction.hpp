// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/cases/family.hpp>

namespace carom::properties {

/// Sets μ, mostly below 1, and the tangential restitution e_t.
void set_friction(Stream& stream, Collision& collision);

/// The μ at which the impulse of `rough`, computed without the friction cone, lies on the cone's surface; rounded, 1 if
/// there is none. The impulse is (1 + ε) P + (1 + e_t) D: P stops the approach, and D then stops the contact point.
[[nodiscard]] double critical_friction(const Collision& collision);

/// The μ at which the impulse of `sticking` lies on the friction cone's surface; rounded, 1 if there is none. Below
/// this μ, `coulomb` slips.
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
