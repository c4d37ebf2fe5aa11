// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/scene/scene.hpp>
#include <carom/scene/valid_scene.hpp>

namespace carom::scene {

/// The first defect of a scene's polyhedra; nothing where they are valid. Numbers are finite and in their ranges, the
/// vertices are the corners of a convex body, mass and moments are numbers of what the scene computes in, and every
/// body is certain to be apart from all others and from the planes: by as much as rounding leaves open, so that bodies
/// which only touch are a defect. Precondition: the scene is valid otherwise (valid_scene.hpp).
[[nodiscard]] std::optional<SceneDefect> first_polyhedron_defect(const Scene& scene);

}  // namespace carom::scene
