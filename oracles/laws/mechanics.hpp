// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/expects.hpp>
#include <carom/oracles/laws/kinematics.hpp>

/// Impulses, momenta and energies of an outcome, for any field T.
namespace carom::oracles {

/// λ = 1/m_A + 1/m_B [1/kg]. An immovable body contributes 0.
template <class T>
[[nodiscard]] T inverse_mass(const BasicCollision<T>& c) {
  T sum(0);
  for (const BasicBody<T>* body : {&c.a, &c.b}) {
    if (!body->immovable) {
      sum += T(1) / body->mass;
    }
  }
  return sum;
}

/// N·V⁻.
template <class T>
[[nodiscard]] T normal_velocity_before(const BasicCollision<T>& c) {
  return c.normal.dot(relative_velocity<T>(c, unchanged(c)));
}

/// m Δv, the impulse that a movable body received [N s].
template <class T>
[[nodiscard]] Vector3<T> impulse_on(const BasicBody<T>& body, const BodyVelocity<T>& after) {
  CAROM_EXPECTS(!body.immovable);
  return body.mass * Vector3<T>(after.velocity - body.velocity);
}

/// Whether A is the lighter movable body. The velocity change of the lighter body gives the impulse most accurately.
/// Precondition: a body is movable.
template <class T>
[[nodiscard]] bool reads_impulse_off_a(const BasicCollision<T>& c) {
  CAROM_EXPECTS(has_movable_body(c));
  return c.b.immovable || (!c.a.immovable && c.a.mass <= c.b.mass);
}

/// F on A [N s], computed from the velocity change of A if `read_off_a`, otherwise from that of B. Precondition: the
/// selected body is movable.
template <class T>
[[nodiscard]] Vector3<T> impulse_on_a(const BasicCollision<T>& c, const Outcome<T>& after, bool read_off_a) {
  return read_off_a ? impulse_on(c.a, after.a) : Vector3<T>(-impulse_on(c.b, after.b));
}

/// X × m Δv + J Δw: the change of a movable body's angular momentum about the world's origin.
template <class T>
[[nodiscard]] Vector3<T> angular_impulse_about_origin(const BasicBody<T>& body, const BodyVelocity<T>& after) {
  return body.position.cross(impulse_on(body, after)) +
         apply_inertia<T>(body, after.angular_velocity - body.angular_velocity);
}

/// The kinetic energy that a movable body gains [kg m²/s²]: ½ m (v⁺² − v⁻²) + ½ (w⁺ᵀ J w⁺ − w⁻ᵀ J w⁻). v⁺² − v⁻² is
/// computed as (v⁺ + v⁻)·(v⁺ − v⁻), because large squares would cancel.
template <class T>
[[nodiscard]] T kinetic_energy_gain(const BasicBody<T>& body, const BodyVelocity<T>& after) {
  const Vector3<T> sum = after.velocity + body.velocity;
  const Vector3<T> angular_sum = after.angular_velocity + body.angular_velocity;
  const Vector3<T> angular_change = after.angular_velocity - body.angular_velocity;
  return (sum.dot(impulse_on(body, after)) + angular_sum.dot(apply_inertia<T>(body, angular_change))) / T(2);
}

}  // namespace carom::oracles
