// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <carom/scene/scene.hpp>

namespace carom::scene {

struct SceneDefect {
  enum class Of : std::uint8_t { scene, pair, plane, sphere, polyhedron };
  Of of = Of::scene;
  std::size_t index = 0;  // of the body among its kind, of the plane, or of the first material of a pair
  std::size_t other = 0;  // of the second material of a pair
  std::string field;      // "radius", …; empty if no single field is wrong
  std::string what;       // "expected a number greater than 0", "sphere 1 (cue) overlaps sphere 0 (eight)", …
};

/// The first defect of a scene except for its polyhedra (valid_polyhedra.hpp); nothing if the scene is valid. Valid
/// numbers are finite and in their ranges. Masses and moments are in the range of the scene's precision. No two
/// bodies overlap (decided exactly); they may touch. The run time is proportional to
/// the number of spheres if their sizes are similar.
[[nodiscard]] std::optional<SceneDefect> first_defect(const Scene& scene);

/// Moves spheres apart from planes and from spheres before them, if the overlap is only rounding of coordinates and
/// radii. Spheres of the radius 0.1 at 0.1 and 0.3 are an example. Precondition: has_valid_fields.
void move_apart(Scene& scene);

/// Whether a body moves within the duration by at most 2¹⁰⁰ m, with an energy of at most 2¹⁰⁰⁰ J, if its greatest speed
/// is `speed` [m/s]. Such numbers do not overflow in any formula, and exact arithmetic is fast.
[[nodiscard]] bool is_moderate(const Scene& scene, double mass, double speed);
inline constexpr const char* of_moderate_motion =
    "expected a motion of at most 2^100 m within the duration, with an energy of at most 2^1000 J";

/// Whether the scene has no defect, except that bodies may overlap.
[[nodiscard]] bool has_valid_fields(const Scene& scene);

/// The defect in one line: "spheres[3].radius: expected …".
[[nodiscard]] std::string describe(const SceneDefect& defect);

/// The range of numbers that a precision rounds with a relative error of at most its unit roundoff. Masses and moments
/// must lie in this range.
struct KnownRange {
  double least, greatest;
  [[nodiscard]] bool contains(double value) const { return value >= least && value <= greatest; }
};

[[nodiscard]] inline KnownRange known_range(Precision precision) {
  if (precision == Precision::binary32) {
    return {std::numeric_limits<float>::min(), std::numeric_limits<float>::max()};
  }
  return {std::numeric_limits<double>::min(), std::numeric_limits<double>::max()};
}

}  // namespace carom::scene
