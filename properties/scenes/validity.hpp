// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <carom/properties/scenes/history.hpp>
#include <carom/scene/scene.hpp>

namespace carom::properties {

struct Invalidity {
  std::size_t body = 0;
  std::string other;  // "sphere 3", "polyhedron 1", "plane 0", or "itself" if the body's own path is wrong
  double begin = 0;   // the violation is between these times [s]
  double end = 0;
  std::string what;  // in words
};

/// Whether a check is to end early.
using Stops = std::function<bool()>;

struct Validity {
  std::vector<Invalidity> invalid;  // the first hundred
  std::size_t count = 0;            // the number of all violations
  std::size_t pairs = 0;            // checked pairs of pieces of paths that are near in space and time
  std::size_t exact_pairs = 0;      // pairs decided in rational numbers
  std::size_t planes = 0;           // checked pieces of a path beside a plane
  std::size_t joints = 0;           // checked joints between successive arcs
  double largest_jump = 0;          // of a stored position at a joint, by rounding [m]
  double unseen = 0;                // for polyhedra: the check may miss an overlap up to this depth [m]
  bool is_complete = true;          // whether the check came to its end; if not, the counts are those of a part

  void add(const Validity& other);
};

/// Checks, independently of the simulation's event loop, that no sphere overlaps another or leaves a plane's side
/// during the history. Arcs are exact polynomials of time. A bound or exact arithmetic decides |x_A − x_B| ≥ R_A + R_B
/// for spheres that come near each other. Successive arcs must join: exactly in time, and in position within 8 ulps of
/// the largest coordinate. `check_polyhedra` checks scenes with polyhedra.
/// The check ends early if `stops` returns true.
[[nodiscard]] Validity check_validity(
    const scene::Scene& scene, const History& history, const Stops& stops = [] { return false; });

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
[[nodiscard]] Validity check_polyhedra(const scene::Scene& scene, const History& history, const Stops& stops);

}  // namespace carom::properties
