// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/collision.hpp>

namespace carom::properties::plan {

/// The class of a contact by its geometry and its moments, as whoever poses it could tell before any impulse is
/// computed: what decides whether a lesser law, or J⁻¹ in world coordinates, serves. One of
///
///   both immovable,
///   central         each movable body's r lies along N, within the rounding of the places that r is the difference of
///   slender         a movable body has moments beyond 1 : 8
///   equal moments   each movable body has three equal ones
///   general         none of these,
///
/// the last four, the first that holds, followed by ", one immovable" or ", both movable". A class is a name for
/// people: no certificate rests on it. Precondition: the collision is valid.
[[nodiscard]] std::string contact_class_of(const Collision& collision);

}  // namespace carom::properties::plan
