// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

#include <carom/collision/model.hpp>
#include <carom/oracles/kinematics.hpp>

/// The exact outcome by superposition: the velocities answer linearly to the impulse, so trial impulses show how, and
/// the law picks the combination. `certify` substitutes it into the defining equations.
namespace carom::oracles {

/// What happens at the contact.
enum class Approach {
  colliding,   // N·V⁻ < 0 and a body can move
  resting,     // N·V⁻ = 0
  separating,  // N·V⁻ > 0
  inert,       // both bodies immovable
};

/// The answer of the law to a collision.
template <class T>
struct Truth {
  Vector3<T> impulse;  // F on A, −F on B [N s]
  Outcome<T> outcome;
};

/// The change of a body's velocities by the impulse F at the contact point; zero where the body is immovable.
template <class T>
[[nodiscard]] BodyVelocity<T> response(const BasicBody<T>& body, const Vector3<T>& point, const Vector3<T>& impulse) {
  if (body.immovable) {
    return {Vector3<T>{T(0), T(0), T(0)}, Vector3<T>{T(0), T(0), T(0)}};
  }
  const Vector3<T> angular_impulse = turned<T>(conjugate(body.orientation), lever_arm(body, point).cross(impulse));
  return {impulse / body.mass, turned<T>(body.orientation, angular_impulse.cwiseQuotient(body.principal_inertia))};
}

/// The change of all velocities by F on A and −F on B.
template <class T>
[[nodiscard]] Outcome<T> response(const BasicCollision<T>& collision, const Vector3<T>& impulse) {
  return {response<T>(collision.a, collision.point, impulse),
          response<T>(collision.b, collision.point, Vector3<T>(-impulse))};
}

/// The collision matrix by its meaning: column i is the change of relative velocity by a unit impulse along axis i.
template <class T>
[[nodiscard]] Matrix3<T> response_matrix(const BasicCollision<T>& collision) {
  Matrix3<T> matrix;
  for (int i = 0; i < 3; ++i) {
    Vector3<T> unit{T(0), T(0), T(0)};
    unit[i] = T(1);
    matrix.col(i) = relative_velocity<T>(collision, response<T>(collision, unit));
  }
  return matrix;
}

/// The solution of M x = b by Cramer's rule. Precondition: M is regular.
template <class T>
[[nodiscard]] Vector3<T> cramer(const Matrix3<T>& m, const Vector3<T>& b) {
  const Vector3<T> c0 = m.col(0);
  const Vector3<T> c1 = m.col(1);
  const Vector3<T> c2 = m.col(2);
  const Vector3<T> c12 = c1.cross(c2);
  const T determinant = c0.dot(c12);
  return Vector3<T>{b.dot(c12), b.dot(c2.cross(c0)), b.dot(c0.cross(c1))} / determinant;
}

/// The law's answer to a contact that collides. T is a field; the sign of N·V⁻ is not asked.
/// Preconditions: a body is movable; the model determines an outcome (`models_with_truth`).
template <class T>
[[nodiscard]] Truth<T> colliding_truth(const BasicCollision<T>& collision, Model model) {
  const Vector3<T>& n = collision.normal;
  const Outcome<T> before = unchanged(collision);
  const T wanted = -(T(1) + collision.restitution) * n.dot(relative_velocity<T>(collision, before));
  Vector3<T> impulse;
  switch (model) {
    case Model::frictionless: {
      const T per_unit = n.dot(relative_velocity<T>(collision, response<T>(collision, n)));
      impulse = n * T(wanted / per_unit);
      break;
    }
    case Model::reflection:
      impulse = cramer<T>(response_matrix(collision), Vector3<T>(n * T(wanted / n.dot(n))));
      break;
    case Model::any:
      throw std::invalid_argument("the model `any` determines no outcome");
  }
  const Outcome<T> change = response<T>(collision, impulse);
  return {impulse,
          {{before.a.velocity + change.a.velocity, before.a.angular_velocity + change.a.angular_velocity},
           {before.b.velocity + change.b.velocity, before.b.angular_velocity + change.b.angular_velocity}}};
}

}  // namespace carom::oracles
