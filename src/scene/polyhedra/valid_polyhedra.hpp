// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/scene/scene.hpp>
#include <carom/scene/valid_scene.hpp>

namespace carom::scene {

/// The first defect of a scene's polyhedra; nothing if they are valid. Valid numbers are finite and in range, and valid
/// vertices are the corners of a convex body. Every body is certain to be apart from all others and from the planes, so
/// bodies that only touch are a defect. Precondition: the scene has no other defect (`first_defect` in
/// valid_scene.hpp).
[[nodiscard]] std::optional<SceneDefect> first_polyhedron_defect(const Scene& scene);

/// Moves each body of a scene with polyhedra apart from planes and from bodies before it that it touches, or overlaps
/// by at most twice the rounding error of their gap.
void move_bodies_apart(Scene& scene);

}  // namespace carom::scene
