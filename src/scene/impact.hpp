// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// What an impact needs to know of a sphere.
struct StruckSphere {
  double mass = 1;                   // [kg]
  double moment = 1;                 // (2/5) m R² [kg m²]
  double radius = 1;                 // [m]
  Vector3<double> position;          // centre, world [m]
  Vector3<double> velocity;          // [m/s]
  Vector3<double> angular_velocity;  // [rad/s]
};

/// The collision of two spheres, as any solver and the oracle take it. Its origin is the contact point, so that lever
/// arms keep their digits wherever the spheres are; the normal is along x_A − x_B, and R_A long.
[[nodiscard]] Collision collision_of(const StruckSphere& a, const StruckSphere& b, const MaterialPair& pair);

/// The collision of a sphere with a fixed plane, which is body B; the normal is along the plane's, and R_A long.
[[nodiscard]] Collision collision_with_plane(const StruckSphere& a, const Vector3<double>& normal,
                                             const MaterialPair& pair);

/// The outcome of spheres by a law, in a precision. No more is computed than spheres need: frictionless and reflection
/// are one scalar division, and turn nothing, exactly; coulomb is rough without tangential restitution. Precondition:
/// made by the functions above; the law is not `any`.
[[nodiscard]] Outcome<double> struck(Model law, Precision precision, const Collision& collision);

/// Adds ulps to velocities until the centres do not approach: (x_A − x_B)·(v_A − v_B) ≥ 0, exactly.
void keep_apart(const Vector3<double>& position_a, const Vector3<double>& position_b, Vector3<double>& velocity_a,
                const Vector3<double>& velocity_b);
/// The same of a plane: N·v ≥ 0.
void keep_apart(const Vector3<double>& normal, Vector3<double>& velocity);

}  // namespace carom::scene
