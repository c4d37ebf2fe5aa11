// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <carom/properties/scenes/history.hpp>
#include <carom/scene/scene.hpp>

namespace carom::properties {

/// Something that must not be in a history.
struct Invalidity {
  std::size_t body = 0;
  std::string other;  // "sphere 3", "polyhedron 1", "plane 0", or "itself" of a path that is not one
  double begin = 0;   // between these times [s]
  double end = 0;
  std::string what;  // in words
};

/// What was found, and how much was looked at.
struct Validity {
  std::vector<Invalidity> invalid;  // the first hundred
  std::size_t count = 0;            // of all that is invalid
  std::size_t pairs = 0;            // pieces of two paths that are near each other in space and time
  std::size_t exact_pairs = 0;      // of them, decided in ℚ
  std::size_t planes = 0;           // pieces of a path beside a plane
  std::size_t joints = 0;           // where one arc follows on another
  double largest_jump = 0;          // of a position there [m]: what storing it has rounded
  double unseen = 0;                // of polyhedra: an overlap no deeper than this would not have been seen [m]

  void add(const Validity& other);
};

/// Whether no sphere overlaps another, or leaves a plane's side, at any time of the history. It knows nothing of the
/// loop: of each sphere it takes the arcs as exact polynomials of time, of all pairs that come near each other, and
/// decides by a bound, or exactly (`oracles::Rational`), that |x_A − x_B| ≥ R_A + R_B throughout. Arcs have to follow
/// on each other: in time exactly, in place within 8 ulps of the largest coordinate. Of a scene with polyhedra all of
/// this is as polyhedra_validity.hpp says.
[[nodiscard]] Validity check_validity(const scene::Scene& scene, const History& history);

}  // namespace carom::properties
