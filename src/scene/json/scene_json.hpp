// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>

#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// Limits of a scene file.
inline constexpr std::size_t most_spheres = 1'000'000;
/// The limit of bodies in a scene with polyhedra, in which every pair of bodies is compared.
inline constexpr std::size_t most_bodies_with_polyhedra = 2000;
inline constexpr std::size_t most_vertices = 100;
inline constexpr std::size_t most_materials = 256;
inline constexpr std::size_t most_planes = 256;

/// The scene of a file (docs/reference/schemas/scene.schema.json). A room becomes six planes, and a lattice becomes
/// spheres. Throws FormatError, with the place in the file, if the JSON is not a scene or the scene is not valid.
[[nodiscard]] Scene scene_from_json(const nlohmann::json& json);

/// The JSON of a scene, with every field written out. Precondition: the scene is valid.
[[nodiscard]] nlohmann::json scene_to_json(const Scene& scene);

}  // namespace carom::scene
