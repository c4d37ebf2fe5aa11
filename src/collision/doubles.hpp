// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/collision/vector.hpp>

/// Collisions and outcomes as doubles in one fixed order, for programs that exchange numbers without JSON.
namespace carom {

/// The flags `immovable` (1 or 0) count as numbers.
inline constexpr std::size_t doubles_of_a_collision = 45;
inline constexpr std::size_t doubles_of_an_outcome = 12;
inline constexpr std::size_t doubles_of_a_matrix = 9;

namespace detail {

/// Calls f(path, place, number) with the place of each number among the doubles. The order is that of for_each_number,
/// and each body begins with its flag `immovable`. Precondition: no body is immovable, so that no number is skipped.
template <class F>
[[gnu::always_inline]] inline void for_each_double(F&& f, Collision& collision) {
  std::size_t place = 0;
  double flag = 0;
  for_each_number(
      [&](const FieldPath& path, double& number) {
        if (path.field == "mass") {
          f(FieldPath{path.body, "immovable"}, place++, flag);
        }
        f(path, place++, number);
      },
      collision);
}

inline constexpr std::size_t place_of_immovable_a = 0;
inline constexpr std::size_t place_of_immovable_b = 18;

}  // namespace detail

/// Body a, body b, point, normal, restitution, friction, tangential restitution. Each body: 1 if it is immovable,
/// otherwise 0; mass, principal inertia, orientation, position, velocity, angular velocity. Of an immovable body, mass,
/// inertia and orientation are 0.
[[nodiscard]] inline std::array<double, doubles_of_a_collision> doubles_of(Collision collision) {
  std::array<double, doubles_of_a_collision> doubles{};
  const std::array flags{collision.a.immovable, collision.b.immovable};
  for (Body* body : {&collision.a, &collision.b}) {
    if (body->immovable) {
      body->immovable = false;
      body->mass = 0;
      body->principal_inertia.setZero();
      body->orientation.setZero();
    }
  }
  detail::for_each_double([&](const FieldPath&, std::size_t place, double number) { doubles[place] = number; },
                          collision);
  doubles[detail::place_of_immovable_a] = flags[0] ? 1 : 0;
  doubles[detail::place_of_immovable_b] = flags[1] ? 1 : 0;
  return doubles;
}

/// The collision with these doubles. A body is immovable if its flag is not 0, and then has the default mass, inertia
/// and orientation.
[[nodiscard]] inline Collision collision_of(std::span<const double, doubles_of_a_collision> doubles) {
  Collision collision;
  detail::for_each_double([&](const FieldPath&, std::size_t place, double& number) { number = doubles[place]; },
                          collision);
  collision.a.immovable = doubles[detail::place_of_immovable_a] != 0;
  collision.b.immovable = doubles[detail::place_of_immovable_b] != 0;
  for (Body* body : {&collision.a, &collision.b}) {
    if (body->immovable) {
      const Body plain;
      body->mass = plain.mass;
      body->principal_inertia = plain.principal_inertia;
      body->orientation = plain.orientation;
    }
  }
  return collision;
}

/// The name of the double at this place: "b.velocity[1]". Precondition: place < doubles_of_a_collision.
[[nodiscard]] inline FieldPath path_of_double(std::size_t place) {
  FieldPath found;
  Collision collision;
  detail::for_each_double(
      [&](const FieldPath& path, std::size_t at, double) {
        if (at == place) {
          found = path;
        }
      },
      collision);
  return found;
}

/// Velocity and angular velocity of A, then those of B.
template <class S>
[[nodiscard]] std::array<double, doubles_of_an_outcome> doubles_of(const Outcome<S>& outcome) {
  std::array<double, doubles_of_an_outcome> doubles{};
  std::size_t place = 0;
  for (const Vector3<S>* vector : vectors(outcome)) {
    for (int i = 0; i < 3; ++i) {
      doubles[place++] = static_cast<double>((*vector)[i]);
    }
  }
  return doubles;
}

template <class S>
[[nodiscard]] Outcome<S> outcome_of(std::span<const double, doubles_of_an_outcome> doubles) {
  Outcome<S> outcome;
  std::size_t place = 0;
  for (Vector3<S>* vector : vectors(outcome)) {
    for (int i = 0; i < 3; ++i) {
      (*vector)[i] = static_cast<S>(doubles[place++]);
    }
  }
  return outcome;
}

/// Row by row.
template <class S>
[[nodiscard]] std::array<double, doubles_of_a_matrix> doubles_of(const Matrix3<S>& matrix) {
  std::array<double, doubles_of_a_matrix> doubles{};
  for (std::size_t place = 0; place < doubles_of_a_matrix; ++place) {
    doubles[place] = static_cast<double>(matrix(static_cast<int>(place / 3), static_cast<int>(place % 3)));
  }
  return doubles;
}

template <class S>
[[nodiscard]] Matrix3<S> matrix_of(std::span<const double, doubles_of_a_matrix> doubles) {
  Matrix3<S> matrix;
  for (std::size_t place = 0; place < doubles_of_a_matrix; ++place) {
    matrix(static_cast<int>(place / 3), static_cast<int>(place % 3)) = static_cast<S>(doubles[place]);
  }
  return matrix;
}

}  // namespace carom
