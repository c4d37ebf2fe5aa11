// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Geometry>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/contact.hpp>

/// Formulas, in double, for the result of an engine on a contact with friction. The formulas come from the source code
/// of the engines. Tests compare them with the answers of the engines.
namespace carom::formulas {

/// The part of a contact that the formulas read.
struct Problem {
  Vector3<double> normal;    // N, unit, from B to A
  Matrix3<double> k;         // K, the collision matrix [1/kg]
  Vector3<double> velocity;  // V⁻ = V_A − V_B, of the material points at the contact [m/s]
  double restitution;        // ε
  double friction;           // μ
};

/// Precondition: the collision is valid.
[[nodiscard]] inline Problem problem_of(const Collision& collision) {
  const auto contact = impulse::make_contact<double>(collision);
  return {contact.normal.normalized(), impulse::collision_matrix(contact), impulse::relative_velocity(contact),
          collision.restitution, collision.friction};
}

/// The velocities after the impulse F on A and −F on B [N s].
[[nodiscard]] inline Outcome<double> outcome_of(const Collision& collision, const Vector3<double>& impulse_on_a) {
  return impulse::apply_impulse(impulse::make_contact<double>(collision), impulse_on_a);
}

/// Shortens a vector to `length` if it is longer.
inline void shorten(Vector3<double>& vector, double length) {
  if (vector.norm() > length) {
    vector *= length / vector.norm();
  }
}

}  // namespace carom::formulas
