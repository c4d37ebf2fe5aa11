// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/stream.hpp>

/// The kinds of a domain: sets of collisions that solvers for a part of the problem solve. docs/reference/domains.md
/// has their formulas.
namespace carom::properties {

enum class Bodies { any, spheres, solid_spheres };
enum class Movable { any, both, one, a, b };
enum class Walls { any, resting };
enum class Plane { any, xy, yz, zx };

struct Kinds {
  Bodies bodies = Bodies::any;
  Movable movable = Movable::any;
  Walls walls = Walls::any;
  Plane plane = Plane::any;

  friend bool operator==(const Kinds&, const Kinds&) = default;
};

/// Whether the kinds permit every collision.
[[nodiscard]] inline bool is_any(const Kinds& kinds) { return kinds == Kinds(); }

/// A kind as text, such as {"plane", "xy"}.
using KindText = std::pair<std::string_view, std::string_view>;

/// Every kind with every value, the wider values first.
[[nodiscard]] const std::vector<KindText>& all_kinds();

/// The kinds that are limited. `set_kind` reads each back.
[[nodiscard]] std::vector<KindText> texts_of(const Kinds& kinds);

/// "bodies", "movable", "walls" and "plane".
[[nodiscard]] std::span<const std::string_view> kind_names();

/// Limits the kind with this name. Throws std::invalid_argument that lists the permitted values. Precondition: `name`
/// is one of `kind_names`.
void set_kind(Kinds& kinds, std::string_view name, std::string_view value);

/// The name of the first kind outside of which the collision lies. Precondition: the collision is valid.
[[nodiscard]] std::optional<std::string_view> kind_outside(const Kinds& kinds, const Collision& collision);

/// Changes a valid collision so that it lies in the kinds, and the lever arms of spheres exactly along the normal.
/// Returns whether a movable body has other moments or another place of the contact. A collision that lies there stays
/// as it is and takes nothing from the stream. The sign of N·V stays, unless N·V becomes 0. The contact lies no further
/// outside of a body than before (`features::overreach`), or not outside.
bool put_into(const Kinds& kinds, Stream& stream, Collision& collision);

/// Takes out of the motion what the kinds exclude: the motion of walls, and motion out of the plane.
void stop_outside(const Kinds& kinds, Collision& collision);

/// Renames the axes x, y, z of the world and of the bodies to y, z, x, without rounding.
void rename_axes(Collision& collision);

/// The place of the coordinate that is zero in the plane; none without a plane.
[[nodiscard]] std::optional<int> normal_axis(const Kinds& kinds);

/// The part of a polar vector in the plane; the vector without a plane.
[[nodiscard]] Vector3<double> in_plane(const Kinds& kinds, Vector3<double> v);

}  // namespace carom::properties
