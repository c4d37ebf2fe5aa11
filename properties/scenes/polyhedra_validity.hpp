// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/scenes/history.hpp>
#include <carom/properties/scenes/validity.hpp>
#include <carom/scene/scene.hpp>

namespace carom::properties {

/// Checks whether bodies of a scene with polyhedra overlap, or leave a plane's side, at any time of the history. The
/// check is independent of the simulation's event loop. It integrates rotations independently (E. Fehlberg's
/// Runge–Kutta method of order 8, in long double). It tests every axis of the separating axis theorem.
///
/// Between two looks at t₁ and t₂, take the gap along a direction that is at rest or turns with a body. It is at least
/// the lesser of the two gaps minus C (t₂ − t₁)²/8, with C a bound of its second derivative. Intervals are halved until
/// this bound excludes an overlap deeper than `Validity::unseen`. That depth is at most 2⁻³⁰ of the lesser radius,
/// unless the limit of halvings is reached.
///
/// Successive arcs must join: exactly in time, in position within the rounding of a parabola, and in orientation within
/// 2⁻³⁸ rad. If a velocity changes at a joint, a plane or another body must touch. Precondition: the scene has
/// polyhedra.
[[nodiscard]] Validity check_polyhedra(const scene::Scene& scene, const History& history);

}  // namespace carom::properties
