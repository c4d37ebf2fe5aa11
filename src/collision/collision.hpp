// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>
#include <tuple>

#include <carom/collision/vector.hpp>

namespace carom {

/// A rigid body at the instant of contact, in world coordinates unless stated otherwise.
template <class S>
struct BasicBody {
  /// Infinite mass. Nothing reads the mass, inertia and orientation of an immovable body. Its velocity may be nonzero
  /// (a driven wall) and never changes.
  bool immovable = false;
  S mass{1};                                          // > 0 [kg]
  Vector3<S> principal_inertia{S{1}, S{1}, S{1}};     // about the centre of mass, along the body axes, > 0 [kg m²]
  Quaternion<S> orientation{S{1}, S{0}, S{0}, S{0}};  // body axes to world axes, any nonzero length
  Vector3<S> position{S{0}, S{0}, S{0}};              // centre of mass [m]
  Vector3<S> velocity{S{0}, S{0}, S{0}};              // of the centre of mass, before the impulse [m/s]
  Vector3<S> angular_velocity{S{0}, S{0}, S{0}};      // before the impulse [rad/s]
};

/// The exact input: two bodies that touch at one point.
template <class S>
struct BasicCollision {
  BasicBody<S> a;
  BasicBody<S> b;
  Vector3<S> point{S{0}, S{0}, S{0}};   // contact point P, world [m]
  Vector3<S> normal{S{0}, S{1}, S{0}};  // on body B, pointing from B to A, world; any nonzero length
  S restitution{1};                     // ε in [0, 1]
  S friction{0};                        // Coulomb coefficient μ ≥ 0; only the laws `rough` and `coulomb` read it
  S tangential_restitution{0};          // e_t in [-1, 1]; only the law `rough` reads it
};

using Body = BasicBody<double>;
using Collision = BasicCollision<double>;

template <class S>
[[nodiscard]] bool has_movable_body(const BasicCollision<S>& collision) {
  return !(collision.a.immovable && collision.b.immovable);
}

/// The name of a number in a collision, such as "a.principal_inertia[2]", "normal[0]" or "restitution".
struct FieldPath {
  std::string_view body;   // "a", "b", or empty for a field of the collision itself
  std::string_view field;  // the name of the field in the line protocol
  int component = -1;      // -1 for a scalar

  [[nodiscard]] std::string text() const {
    std::string path{body};
    if (!path.empty()) {
      path += '.';
    }
    path += field;
    if (component >= 0) {
      path += '[' + std::to_string(component) + ']';
    }
    return path;
  }
};

namespace detail {

// These functions are inlined, so that the compiler leaves out the paths that `f` does not read.
template <class F, class... Vectors>
[[gnu::always_inline]] inline void for_each_component(std::string_view body, std::string_view field, F& f,
                                                      Vectors&... vectors) {
  const int size = static_cast<int>(std::get<0>(std::tie(vectors...)).size());
  for (int i = 0; i < size; ++i) {
    f(FieldPath{body, field, i}, vectors[i]...);
  }
}

template <class F, class... Bodies>
[[gnu::always_inline]] inline void for_each_body_number(std::string_view name, F& f, Bodies&... bodies) {
  if (!std::get<0>(std::tie(bodies...)).immovable) {
    f(FieldPath{name, "mass"}, bodies.mass...);
    for_each_component(name, "principal_inertia", f, bodies.principal_inertia...);
    for_each_component(name, "orientation", f, bodies.orientation...);
  }
  for_each_component(name, "position", f, bodies.position...);
  for_each_component(name, "velocity", f, bodies.velocity...);
  for_each_component(name, "angular_velocity", f, bodies.angular_velocity...);
}

}  // namespace detail

/// Visits the numbers of all collisions in one fixed order. For each path, calls f(path, numbers...) with the number of
/// each collision at this path. Skips the mass, inertia and orientation of a body that is immovable in the first
/// collision.
template <class F, class... Collisions>
[[gnu::always_inline]] inline void for_each_number(F&& f, Collisions&... collisions) {
  detail::for_each_body_number("a", f, collisions.a...);
  detail::for_each_body_number("b", f, collisions.b...);
  detail::for_each_component("", "point", f, collisions.point...);
  detail::for_each_component("", "normal", f, collisions.normal...);
  f(FieldPath{"", "restitution"}, collisions.restitution...);
  f(FieldPath{"", "friction"}, collisions.friction...);
  f(FieldPath{"", "tangential_restitution"}, collisions.tangential_restitution...);
}

/// The same collision in another scalar type: each number x becomes convert(x).
template <class T, class S, class Convert>
[[nodiscard]] BasicCollision<T> map_numbers(const BasicCollision<S>& collision, Convert&& convert) {
  BasicCollision<T> mapped;
  mapped.a.immovable = collision.a.immovable;
  mapped.b.immovable = collision.b.immovable;
  for_each_number([&](const FieldPath&, const S& from, T& to) { to = convert(from); }, collision, mapped);
  return mapped;
}

}  // namespace carom
