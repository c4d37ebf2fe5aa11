// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <carom/scene/scene.hpp>

namespace carom::scene {

/// What is wrong with a scene.
struct SceneDefect {
  enum class Of : std::uint8_t { scene, pair, plane, sphere, polyhedron };
  Of of = Of::scene;
  std::size_t index = 0;  // of the body among its kind, or the plane; of a pair its first material
  std::size_t other = 0;  // of a pair its second material
  std::string field;      // "radius", …; empty where no field is to blame alone
  std::string what;       // "expected a number greater than 0", "sphere 1 (cue) overlaps sphere 0 (eight)", …
};

/// The first defect; nothing where the scene is valid, its polyhedra apart (valid_polyhedra.hpp). Numbers are finite
/// and in their ranges, gravity is along an axis of the world, masses and moments are numbers of what the scene
/// computes in, and no two bodies overlap, which is decided exactly: to touch is not to overlap. Takes time in
/// proportion to the number of spheres, where they are of like sizes.
[[nodiscard]] std::optional<SceneDefect> first_defect(const Scene& scene);

/// Whether there is no defect but that bodies may overlap.
[[nodiscard]] bool has_valid_fields(const Scene& scene);

/// As one line: "spheres[3].radius: expected …".
[[nodiscard]] std::string describe(const SceneDefect& defect);

}  // namespace carom::scene
