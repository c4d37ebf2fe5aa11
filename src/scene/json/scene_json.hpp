// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>

#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// What a scene file may have at most.
inline constexpr std::size_t most_spheres = 1'000'000;
/// Of bodies where there are polyhedra: each is compared with each.
inline constexpr std::size_t most_bodies_with_polyhedra = 2000;
inline constexpr std::size_t most_vertices = 100;
inline constexpr std::size_t most_materials = 256;
inline constexpr std::size_t most_planes = 256;

/// The scene of a file (docs/reference/schemas/scene.schema.json): rooms are six planes then, lattices spheres. Throws
/// FormatError where the file is no scene, or one that is not valid (valid_scene.hpp, valid_polyhedra.hpp); its text
/// names the place.
[[nodiscard]] Scene scene_from_json(const nlohmann::json& json);

/// The other way round, with everything written out. Precondition: the scene is valid.
[[nodiscard]] nlohmann::json scene_to_json(const Scene& scene);

}  // namespace carom::scene
