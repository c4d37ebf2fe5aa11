// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <carom/oracles/laws/kinematics.hpp>

/// The defining equations, about a page: what has to be trusted. Each gives the two sides of an equation or inequality
/// for any outcome, exact or not, in any field T. Everything is judged by these.
namespace carom::oracles {

template <class T, int N>
struct Sides {
  Eigen::Matrix<T, N, 1> left;
  Eigen::Matrix<T, N, 1> right;
};

template <class T>
using Scalar1 = Eigen::Matrix<T, 1, 1>;

/// m Δv, the impulse that a movable body received [N s].
template <class T>
[[nodiscard]] Vector3<T> impulse_on(const BasicBody<T>& body, const BodyVelocity<T>& after) {
  return body.mass * Vector3<T>(after.velocity - body.velocity);
}

/// F on A, read off the movable body whose velocity shows it best: the lighter one.
/// Precondition: a body is movable.
template <class T>
[[nodiscard]] Vector3<T> impulse_on_a(const BasicCollision<T>& c, const Outcome<T>& after, bool read_off_a) {
  return read_off_a ? impulse_on(c.a, after.a) : Vector3<T>(-impulse_on(c.b, after.b));
}

/// m_A Δv_A = −m_B Δv_B. Precondition: both bodies are movable.
template <class T>
[[nodiscard]] Sides<T, 3> linear_momentum(const BasicCollision<T>& c, const Outcome<T>& after) {
  return {impulse_on(c.a, after.a), -impulse_on(c.b, after.b)};
}

/// J Δw = r × m Δv. Precondition: the body is movable.
template <class T>
[[nodiscard]] Sides<T, 3> angular_momentum(const BasicBody<T>& body, const Vector3<T>& point,
                                           const BodyVelocity<T>& after) {
  return {apply_inertia<T>(body, after.angular_velocity - body.angular_velocity),
          lever_arm(body, point).cross(impulse_on(body, after))};
}

/// X × m Δv + J Δw: the change of a movable body's angular momentum about the world's origin.
template <class T>
[[nodiscard]] Vector3<T> angular_impulse_about_origin(const BasicBody<T>& body, const BodyVelocity<T>& after) {
  return body.position.cross(impulse_on(body, after)) +
         apply_inertia<T>(body, after.angular_velocity - body.angular_velocity);
}

/// What A gains about the origin, B loses. With linear momentum kept it then holds about every point.
/// Precondition: both bodies are movable.
template <class T>
[[nodiscard]] Sides<T, 3> total_angular_momentum(const BasicCollision<T>& c, const Outcome<T>& after) {
  return {angular_impulse_about_origin(c.a, after.a), -angular_impulse_about_origin(c.b, after.b)};
}

/// The velocities of one body are as before.
template <class T>
[[nodiscard]] Sides<T, 6> untouched(const BasicBody<T>& body, const BodyVelocity<T>& after) {
  Sides<T, 6> sides;
  sides.left << after.velocity, after.angular_velocity;
  sides.right << body.velocity, body.angular_velocity;
  return sides;
}

/// N·V⁻.
template <class T>
[[nodiscard]] T normal_velocity_before(const BasicCollision<T>& c) {
  return c.normal.dot(relative_velocity<T>(c, unchanged(c)));
}

/// N·V⁺ = −ε N·V⁻ (note eq. 17).
template <class T>
[[nodiscard]] Sides<T, 1> restitution(const BasicCollision<T>& c, const Outcome<T>& after) {
  return {Scalar1<T>(c.normal.dot(relative_velocity<T>(c, after))),
          Scalar1<T>(-c.restitution * normal_velocity_before(c))};
}

/// N·V⁺ ≥ 0.
template <class T>
[[nodiscard]] Sides<T, 1> non_penetration(const BasicCollision<T>& c, const Outcome<T>& after) {
  return {Scalar1<T>(c.normal.dot(relative_velocity<T>(c, after))), Scalar1<T>(T(0))};
}

/// N·F ≥ 0: contacts push. Precondition: a body is movable.
template <class T>
[[nodiscard]] Sides<T, 1> push(const BasicCollision<T>& c, const Outcome<T>& after, bool read_off_a) {
  return {Scalar1<T>(c.normal.dot(impulse_on_a(c, after, read_off_a))), Scalar1<T>(T(0))};
}

/// N × F = 0 (note eq. 10 to 18). Precondition: a body is movable.
template <class T>
[[nodiscard]] Sides<T, 3> frictionless_direction(const BasicCollision<T>& c, const Outcome<T>& after, bool read_off_a) {
  return {c.normal.cross(impulse_on_a(c, after, read_off_a)), Vector3<T>{T(0), T(0), T(0)}};
}

/// N × V⁺ = N × V⁻ (note eq. 20, 21 without the basis).
template <class T>
[[nodiscard]] Sides<T, 3> reflection_plane(const BasicCollision<T>& c, const Outcome<T>& after) {
  return {c.normal.cross(relative_velocity<T>(c, after)), c.normal.cross(relative_velocity<T>(c, unchanged(c)))};
}

/// The kinetic energy that a movable body gains, ½ m (v⁺² − v⁻²) + ½ (w⁺ᵀ J w⁺ − w⁻ᵀ J w⁻), written with sums and
/// differences so that a large common velocity cancels. [J]
template <class T>
[[nodiscard]] T kinetic_energy_gain(const BasicBody<T>& body, const BodyVelocity<T>& after) {
  const Vector3<T> sum = after.velocity + body.velocity;
  const Vector3<T> angular_sum = after.angular_velocity + body.angular_velocity;
  const Vector3<T> angular_change = after.angular_velocity - body.angular_velocity;
  return (sum.dot(impulse_on(body, after)) + angular_sum.dot(apply_inertia<T>(body, angular_change))) / T(2);
}

/// E⁺ − E⁻ ≤ W: the kinetic energy of the movable bodies grows by no more than the work that a driven wall does with
/// its contact point's velocity. Precondition: a body is movable.
template <class T>
[[nodiscard]] Sides<T, 1> energy(const BasicCollision<T>& c, const Outcome<T>& after) {
  T gain(0);
  T work(0);
  const auto wall_velocity = [&](const BasicBody<T>& body) {
    return point_velocity<T>({body.velocity, body.angular_velocity}, lever_arm(body, c.point));
  };
  if (c.a.immovable) {
    work += wall_velocity(c.a).dot(impulse_on(c.b, after.b));
  } else {
    gain += kinetic_energy_gain(c.a, after.a);
  }
  if (c.b.immovable) {
    work += wall_velocity(c.b).dot(impulse_on(c.a, after.a));
  } else {
    gain += kinetic_energy_gain(c.b, after.b);
  }
  return {Scalar1<T>(gain), Scalar1<T>(work)};
}

}  // namespace carom::oracles
