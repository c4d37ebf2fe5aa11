// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/scenes/history.hpp>
#include <carom/properties/scenes/validity.hpp>
#include <carom/scene/scene.hpp>

namespace carom::properties {

/// Checks whether the bodies of a scene with polyhedra overlap, or leave a plane's side, during the history. The check
/// shares nothing with the simulation's event loop. It tests every axis of the separating axis theorem.
///
/// A look computes the gap of two bodies at one time. Let C be a bound of the second derivative of the gap along a
/// fixed or turning direction. Between looks at t₁ and t₂, this gap is at least the lesser of its values at the looks
/// minus C (t₂ − t₁)²/8. The check halves the time between looks until it excludes an overlap deeper than
/// `Validity::unseen`. `unseen` is at most 2⁻³⁰ of the lesser radius, unless the check reaches the limit of halvings.
///
/// Successive arcs must join: exactly in time, in position within the rounding of a parabola, and in orientation within
/// 2⁻³⁸ rad. If a velocity changes at a joint, a plane or another body must touch the body. Precondition:
/// `scene.polyhedra` is not empty.
[[nodiscard]] Validity check_polyhedra(const scene::Scene& scene, const History& history);

}  // namespace carom::properties
