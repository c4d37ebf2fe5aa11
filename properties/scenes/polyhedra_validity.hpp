// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/scenes/history.hpp>
#include <carom/properties/scenes/validity.hpp>
#include <carom/scene/scene.hpp>

namespace carom::properties {

/// Checks whether bodies of a scene with polyhedra overlap, or leave a plane's side, at any time of the history. The
/// check is independent of the simulation's event loop. `BodyTrack` integrates the rotations. The check tests every
/// axis of the separating axis theorem.
///
/// A look computes two poses and their gap at one time. Take looks at t₁ and t₂, and a direction that is at rest or
/// turns with a body. Between the looks, the gap along it is at least the lesser of the two gaps minus C (t₂ − t₁)²/8,
/// with C a bound of the gap's second derivative. Intervals are halved until this bound excludes an overlap deeper than
/// `Validity::unseen`. `unseen` is at most 2⁻³⁰ of the lesser radius, unless the limit of halvings is reached.
///
/// Successive arcs must join: exactly in time, in position within the rounding of a parabola, and in orientation within
/// 2⁻³⁸ rad. If a velocity changes at a joint, a plane or another body must touch the body. Precondition:
/// `scene.polyhedra` is not empty.
[[nodiscard]] Validity check_polyhedra(const scene::Scene& scene, const History& history);

}  // namespace carom::properties
