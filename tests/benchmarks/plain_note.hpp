// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>

/// The note as the author of a game writes it, in plain C++ and double: an object a body, whose state are its momenta,
/// a basis of one normal and two tangents, and the inverse of a 3×3 matrix. What the batches are measured against. It
/// shares no text with the library, and takes on trust what such code does: it fails where the relative velocity is
/// nearly along the normal (docs/findings/note.md).
namespace carom::benchmarks::plain {

struct Vector {
  double x, y, z;
};

struct Matrix {
  std::array<Vector, 3> rows;
};

/// What changes in a collision. The velocities are derived from the momenta.
struct Motion {
  Vector momentum;          // kg m/s
  Vector angular_momentum;  // kg m²/s, about the centre of mass
  Vector velocity;          // m/s
  Vector angular_velocity;  // rad/s
};

/// In world coordinates. An immovable body has no inverse mass and no inverse inertia, and so no velocities.
struct RigidBody {
  double mass;
  double inverse_mass;
  Matrix inverse_inertia;
  Vector position;
  Motion motion;
};

/// Two bodies that touch. They are the caller's.
struct Contact {
  const RigidBody* a;
  const RigidBody* b;
  Vector point;
  Vector normal;  // of length 1, on B, pointing from B to A
  double restitution;
};

struct Motions {
  Motion a;
  Motion b;
};

/// Precondition: the collision is valid, and what is immovable rests.
[[nodiscard]] RigidBody rigid_body(const Body& body);
/// Of bodies made from the same collision, which outlive it.
[[nodiscard]] Contact contact(const Collision& collision, const RigidBody& a, const RigidBody& b);

/// An impulse along the normal: note §1, eq. 18.
[[nodiscard]] Motions solve_frictionless(const Contact& contact);
/// The relative velocity is reflected: note §2, eq. 20 to 29 as corrected in docs/findings/note.md.
[[nodiscard]] Motions solve_reflection(const Contact& contact);

[[nodiscard]] Outcome<double> outcome(const Motions& motions);

}  // namespace carom::benchmarks::plain
