// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/collision.hpp>

namespace carom::properties::plan {

/// The class of a contact, by its geometry and moments. These decide whether a cheaper law, or J⁻¹ in world axes,
/// serves. The classes:
///
///   `both immovable`
///   `central`: Each movable body's lever arm r is parallel to N, within the rounding of P and X
///   `slender`: A movable body's greatest moment is more than 8 times its least
///   `equal moments`: Each movable body has three equal moments
///   `general`: All others.
///
/// If a body is movable, the class is the first of the last four that holds, with ", one immovable" or ", both movable"
/// added. Certificates do not depend on classes. Precondition: the collision is valid.
[[nodiscard]] std::string contact_class_of(const Collision& collision);

}  // namespace carom::properties::plan
