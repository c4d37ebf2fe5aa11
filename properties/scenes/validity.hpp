// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
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

struct Validity {
  std::vector<Invalidity> invalid;  // the first hundred
  std::size_t count = 0;            // the number of all violations
  std::size_t pairs = 0;            // checked pairs of pieces of paths that are near in space and time
  std::size_t exact_pairs = 0;      // pairs decided in rational numbers
  std::size_t planes = 0;           // checked pieces of a path beside a plane
  std::size_t joints = 0;           // checked joints between successive arcs
  double largest_jump = 0;          // of a stored position at a joint, by rounding [m]
  double unseen = 0;                // for polyhedra: the check may miss an overlap up to this depth [m]

  void add(const Validity& other);
};

/// Checks, independently of the simulation's event loop, that no sphere overlaps another or leaves a plane's side
/// during the history. Arcs are exact polynomials of time. A bound or exact arithmetic decides |x_A − x_B| ≥ R_A + R_B
/// for spheres that come near each other. Successive arcs must join: exactly in time, and in position within 8 ulps of
/// the largest coordinate. polyhedra_validity.hpp checks scenes with polyhedra.
[[nodiscard]] Validity check_validity(const scene::Scene& scene, const History& history);

}  // namespace carom::properties
