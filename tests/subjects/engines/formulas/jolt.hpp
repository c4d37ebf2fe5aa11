// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <carom/collision/outcome.hpp>

#include "problem.hpp"

namespace carom::formulas {

/// The settings of Jolt that affect the first contact of two bodies, without gravity.
struct JoltSettings {
  int velocity_steps;                   // PhysicsSettings::mNumVelocitySteps
  double min_velocity_for_restitution;  // PhysicsSettings::mMinVelocityForRestitution [m/s]
  double damping;                       // mLinearDamping and mAngularDamping [1/s]
  double max_linear_velocity;           // mMaxLinearVelocity [m/s]
  double max_angular_velocity;          // mMaxAngularVelocity [rad/s]
  double step;                          // [s]
};

[[nodiscard]] inline JoltSettings jolt_as_shipped() { return {10, 1.0, 0.05, 500, 15 * std::numbers::pi, 1.0 / 60}; }
[[nodiscard]] inline JoltSettings jolt_configured() { return {20, 0, 0, 1e18, 1e18, 1.0 / 60}; }

/// The tangent that Jolt chooses: in the world's x z plane if |N_x| > |N_y|, else in the y z plane.
[[nodiscard]] inline Vector3<double> jolt_tangent(const Vector3<double>& normal) {
  const bool in_xz = std::abs(normal.x()) > std::abs(normal.y());
  return (in_xz ? Vector3<double>(normal.z(), 0, -normal.x()) : Vector3<double>(0, normal.z(), -normal.y()))
      .normalized();
}

/// The impulse F of Jolt's sequential impulses. T_1 = jolt_tangent(N), T_2 = N × T_1, k_i = T_i·K T_i and V = V⁻ + K F.
/// F starts at 0. In each step:
///
///  f_i = F·T_i − T_i·V / k_i for i = 1, 2, with the same V; if ‖f‖ > μ F·N, f ← f μ F·N / ‖f‖
///  F ← (F·N) N + f_1 T_1 + f_2 T_2
///  F·N ← max(0, F·N − (N·V + ε' N·V⁻) / N·K N)
///
/// ε' = ε if −N·V⁻ exceeds min_velocity_for_restitution, else 0. The limit μ F·N uses F·N of the previous step. Source:
/// JoltPhysics: ContactConstraintManager.cpp, sSolveVelocityConstraint and
/// CalculateFrictionAndNonPenetrationConstraintProperties; Vec3::GetNormalizedPerpendicular.
[[nodiscard]] inline Vector3<double> jolt_impulse(const Problem& problem, const JoltSettings& settings) {
  const Vector3<double>& normal = problem.normal;
  const Vector3<double> tangents[] = {jolt_tangent(normal), normal.cross(jolt_tangent(normal))};
  const double approach = normal.dot(problem.velocity);
  const double asked = problem.restitution > 0 && approach < -settings.min_velocity_for_restitution
                           ? -problem.restitution * approach
                           : 0;
  double pushing = 0;
  Vector3<double> friction = Vector3<double>::Zero();
  const auto velocity = [&]() -> Vector3<double> {
    return problem.velocity + problem.k * (pushing * normal + friction);
  };
  for (int step = 0; step < settings.velocity_steps; ++step) {
    const Vector3<double> before = velocity();
    for (const Vector3<double>& tangent : tangents) {
      friction -= tangent.dot(before) / tangent.dot(problem.k * tangent) * tangent;
    }
    const double limit = problem.friction * pushing;
    if (friction.norm() > limit) {
      friction *= limit / friction.norm();
    }
    pushing = std::max(0.0, pushing - (normal.dot(velocity()) - asked) / normal.dot(problem.k * normal));
  }
  return pushing * normal + friction;
}

/// The outcome of Jolt. Before it solves the contact, Jolt multiplies the velocities of movable bodies by 1 − damping ·
/// step and clamps them to their limits (MotionProperties::ApplyForceTorqueAndDragInternal), even if the bodies
/// separate. After the contact, Jolt clamps the velocities again (PhysicsSystem::JobIntegrateVelocity). Precondition:
/// the collision is valid and at least one body can move.
[[nodiscard]] inline Outcome<double> jolt(const Collision& collision, const JoltSettings& settings) {
  const auto limit_speeds = [&](auto& body) {
    shorten(body.velocity, settings.max_linear_velocity);
    shorten(body.angular_velocity, settings.max_angular_velocity);
  };
  Collision damped = collision;
  for (Body* body : {&damped.a, &damped.b}) {
    if (!body->immovable) {
      const double factor = std::max(0.0, 1 - settings.damping * settings.step);
      body->velocity *= factor;
      body->angular_velocity *= factor;
      limit_speeds(*body);
    }
  }
  Outcome<double> outcome = outcome_of(damped, jolt_impulse(problem_of(damped), settings));
  if (!collision.a.immovable) {
    limit_speeds(outcome.a);
  }
  if (!collision.b.immovable) {
    limit_speeds(outcome.b);
  }
  return outcome;
}

}  // namespace carom::formulas
