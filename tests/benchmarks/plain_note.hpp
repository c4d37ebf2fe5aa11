// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>

/// The note (docs/findings/note.md) as a game developer would implement it, in plain C++ and double. Each body is an
/// object with its momenta as state. The solver uses a basis of a normal and two tangents, and the inverse of a 3×3
/// matrix. The benchmarks compare the library's solvers with this solver, which shares no code with them. Like the
/// note, this solver fails if the relative velocity is nearly along the normal.
namespace carom::benchmarks::plain {

struct Vector {
  double x, y, z;
};

struct Matrix {
  std::array<Vector, 3> rows;
};

struct Motion {
  Vector momentum;          // kg m/s
  Vector angular_momentum;  // kg m²/s, about the centre of mass
  Vector velocity;          // m/s
  Vector angular_velocity;  // rad/s
};

/// A body in world coordinates. The inverse mass and inertia of an immovable body are 0.
struct RigidBody {
  double mass;
  double inverse_mass;
  Matrix inverse_inertia;
  Vector position;
  Motion motion;
};

/// The bodies must outlive the contact.
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

/// Precondition: the collision is valid, and an immovable body is at rest.
[[nodiscard]] RigidBody rigid_body(const Body& body);
/// Precondition: both bodies are made from this collision.
[[nodiscard]] Contact contact(const Collision& collision, const RigidBody& a, const RigidBody& b);

/// Applies an impulse along the normal: note §1, eq. 18.
[[nodiscard]] Motions solve_frictionless(const Contact& contact);
/// Reflects the relative velocity: note §2, eq. 20 to 29 as corrected in docs/findings/note.md.
[[nodiscard]] Motions solve_reflection(const Contact& contact);

[[nodiscard]] Outcome<double> outcome(const Motions& motions);

}  // namespace carom::benchmarks::plain
