// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>
#include <carom/collision/law.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/collision/precision.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// The properties of a sphere that determine an impact.
struct StruckSphere {
  double mass = 1;                   // [kg]
  double moment = 1;                 // (2/5) m R² [kg m²]
  double radius = 1;                 // [m]
  Vector3<double> position;          // centre, world [m]
  Vector3<double> velocity;          // [m/s]
  Vector3<double> angular_velocity;  // [rad/s]
};

/// The collision of two spheres. Its origin is the contact point, so that lever arms keep their digits. The normal is
/// along the difference x_A − x_B of the centres, with the length R_A.
[[nodiscard]] Collision collision_of(const StruckSphere& a, const StruckSphere& b, const MaterialPair& pair);

/// The collision of a sphere with a fixed plane, which is body B. `normal` may have any length; the collision's normal
/// has the length R_A.
[[nodiscard]] Collision collision_with_plane(const StruckSphere& a, const Vector3<double>& normal,
                                             const MaterialPair& pair);

/// The outcome of a collision of spheres by a law, computed in a precision. The laws `frictionless` and `reflection`
/// leave the spins exactly unchanged. For `coulomb`, the function computes `rough` with e_t = 0. Preconditions:
/// collision_of or collision_with_plane made the collision; the law is not `any`.
[[nodiscard]] Outcome<double> struck(Law law, Precision precision, const Collision& collision);

/// Adds ulps to velocity_a until the centres do not approach: (x_A − x_B)·(v_A − v_B) ≥ 0 exactly.
void keep_apart(const Vector3<double>& position_a, const Vector3<double>& position_b, Vector3<double>& velocity_a,
                const Vector3<double>& velocity_b);
/// Adds ulps to the velocity of a sphere until it does not approach a plane: N·v ≥ 0 exactly.
void keep_apart(const Vector3<double>& normal, Vector3<double>& velocity);

/// The outcome of a law, computed in a precision, for bodies of any shape. Preconditions: the collision is valid; the
/// law is not `any`.
[[nodiscard]] Outcome<double> struck_bodies(Law law, Precision precision, const Collision& collision);

/// The outcome of an impulse along the normal that makes N·V/‖N‖ at least `speed` [m/s], with V the velocity of A's
/// contact point relative to B's. Precondition: the collision is valid.
[[nodiscard]] Outcome<double> sent_apart(const Collision& collision, double speed);

/// N·V/‖N‖, the speed at which the contact points part [m/s].
[[nodiscard]] double parting_speed(const Collision& collision);

}  // namespace carom::scene
