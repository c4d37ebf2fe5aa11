// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/oracles/laws/fraction.hpp>

/// The kinematics of the defining equations, for any field T, such as rationals or dual numbers.
namespace carom::oracles {

template <class T>
[[nodiscard]] Quaternion<T> conjugate(const Quaternion<T>& q) {
  return {q[0], -q[1], -q[2], -q[3]};
}

/// q v q* / ‖q‖²: v turned by the rotation of the quaternion q = (w, u), with its conjugate q*. Let t = w v + u × v.
/// Then q v = (−u·v, t), and the vector part of q v q* is (u·v) u + w t + u × t.
template <class T>
[[nodiscard]] Vector3<T> turned(const Quaternion<T>& q, const Vector3<T>& v) {
  const T& w = q[0];
  const Vector3<T> u = q.template tail<3>();
  const T inverse_squared_length = T(1) / q.dot(q);  // one division instead of three
  return mapped_linearly(v, [&](const Vector3<T>& x) {
    const Vector3<T> t = w * x + u.cross(x);
    return Vector3<T>(Vector3<T>(u.dot(x) * u + w * t + u.cross(t)) * inverse_squared_length);
  });
}

/// J x in world axes, with the inertia tensor J of the body. Precondition: the body is movable.
template <class T>
[[nodiscard]] Vector3<T> apply_inertia(const BasicBody<T>& body, const Vector3<T>& x) {
  CAROM_EXPECTS(!body.immovable);
  const Vector3<T> in_body = turned<T>(conjugate(body.orientation), x);
  return turned<T>(body.orientation, in_body.cwiseProduct(body.principal_inertia));
}

/// r = P − X.
template <class T>
[[nodiscard]] Vector3<T> lever_arm(const BasicBody<T>& body, const Vector3<T>& point) {
  return point - body.position;
}

/// v + w × r, the velocity of the body's material point at P.
template <class T>
[[nodiscard]] Vector3<T> point_velocity(const BodyVelocity<T>& motion, const Vector3<T>& lever_arm) {
  return motion.velocity +
         mapped_linearly(motion.angular_velocity, [&](const Vector3<T>& w) { return Vector3<T>(w.cross(lever_arm)); });
}

/// V = V_A − V_B at the contact point.
template <class T>
[[nodiscard]] Vector3<T> relative_velocity(const BasicCollision<T>& collision, const Outcome<T>& motion) {
  return point_velocity<T>(motion.a, lever_arm(collision.a, collision.point)) -
         point_velocity<T>(motion.b, lever_arm(collision.b, collision.point));
}

}  // namespace carom::oracles
