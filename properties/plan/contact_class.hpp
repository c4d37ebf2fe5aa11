// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/collision.hpp>

namespace carom::properties::plan {

/// The class of a contact. It depends on the geometry and the moments alone, so that a user can tell it before any
/// impulse is computed. These decide whether a lesser law, or J⁻¹ in world coordinates, serves. The classes:
///
///   `both immovable`
///   `central`: Each movable body's r is parallel to N, within the rounding of P and X
///   `slender`: A movable body's greatest moment is more than 8 times its least
///   `equal moments`: Each movable body has three equal moments
///   `general`: None of these.
///
/// The first of the last four that holds is the class, followed by ", one immovable" or ", both movable". Classes are
/// names for users; no certificate depends on them. Precondition: the collision is valid.
[[nodiscard]] std::string contact_class_of(const Collision& collision);

}  // namespace carom::properties::plan
