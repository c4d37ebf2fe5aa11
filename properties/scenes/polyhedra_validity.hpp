// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/scenes/history.hpp>
#include <carom/properties/scenes/validity.hpp>
#include <carom/scene/scene.hpp>

namespace carom::properties {

/// Whether bodies of a scene with polyhedra overlap, or leave a plane's side, at any time of the history. It knows
/// nothing of the loop: rotations are integrated anew (E. Fehlberg's Runge–Kutta method of order 8, in long double),
/// and whether bodies are apart is asked of every axis of the separating axis theorem.
///
/// Between two looks at t₁ and t₂ the gap along a direction, at rest or turning with a body, is at least the lesser of
/// both less C (t₂ − t₁)²/8, C a bound of its second derivative. Intervals are halved until that leaves no overlap, or
/// none deeper than `Validity::unseen`, which is at most 2⁻³⁰ of the lesser radius but where halving ends.
///
/// Arcs have to follow on each other: in time exactly, in place within the rounding of a parabola, in orientation
/// within 2⁻³⁸ rad; and where a velocity changes something has to touch. Precondition: the scene has polyhedra.
[[nodiscard]] Validity check_polyhedra(const scene::Scene& scene, const History& history);

}  // namespace carom::properties
