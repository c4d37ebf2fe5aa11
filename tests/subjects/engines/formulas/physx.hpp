// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "problem.hpp"

namespace carom::formulas {

/// PhysX's default angular damping over one step, before the contact is solved: w ← (1 − 0.05 1/s · 1/60 s) w.
[[nodiscard]] inline Collision with_damped_spins(Collision collision) {
  for (Body* body : {&collision.a, &collision.b}) {
    if (!body->immovable) {
      body->angular_velocity *= 1 - 0.05 / 60;
    }
  }
  return collision;
}

/// The outcome of PhysX 5.6.1 with its default solver, PGS, for the first contact of two bodies. N is the normal, v_A
/// and v_B are the velocities of the centres of mass, u = v_A − v_B, and T0 and T1 are the axes of friction:
///
///  T0 = u_T / ‖u_T‖ if u_T = u − (N·u) N is longer than 0.01 m/s,
///  else N rotated by a right angle about the x axis (about z if N is within 45° of x) and normalised;
///  T1 = N × T0.
///
/// F starts at 0. The solver repeats 5 times (`configured`: 259 times), the first time without friction:
///
///  F_N ← max(0, F_N + (R − V_N) / K_NN),
///  F_0 ← clamp(F_0 − 0.8 V_0 / K_00, ±μ F_N),
///  F_1 ← clamp(F_1 − 0.8 V_1 / K_11, ±μ F_N).
///
/// Each line updates V = V⁻ + K F. R = −ε V_N⁻ if V_N⁻ < −2 m/s (`configured`: V_N⁻ < 0), else 0. As shipped, the spins
/// are damped first. If R = 0 as shipped, the first 4 iterations use R = 0.8 · depth · 60 Hz, which corrects the
/// overlap.
///
/// Friction is limited along each axis separately. The axes depend on u, not on the slip of the contact point. In the
/// last iteration, friction changes V_N after the update of F_N, and no later update corrects V_N.
///
/// Source: physx/source/lowleveldynamics/src: DyContactPrep.cpp, `setupFinalizeSolverConstraints` (T0, T1, 0.8);
/// DyContactPrepShared.h, `constructContactConstraint` (R); DySolverConstraintsShared.h, `solveDynamicContacts`, and
/// DySolverConstraints.cpp, `solveContact` (the updates of F); DySolverControl.cpp, `solveV_Blocks` (the iterations).
///
/// The formula omits the limit of spins, 100 rad/s as shipped. `depth` is the depth of the overlap [m].
[[nodiscard]] inline Outcome<double> physx(const Collision& given, bool configured, double depth) {
  const Collision collision = configured ? given : with_damped_spins(given);
  const Problem problem = problem_of(collision);
  const Vector3<double>& n = problem.normal;
  const Vector3<double> u = collision.a.velocity - collision.b.velocity;
  Vector3<double> t = u - n.dot(u) * n;
  if (t.squaredNorm() <= 1e-4) {
    t = std::abs(n[0]) < std::sqrt(0.5) ? Vector3<double>{0, -n[2], n[1]} : Vector3<double>{-n[1], n[0], 0};
  }
  t.normalize();
  const std::array<Vector3<double>, 3> axes{n, t, n.cross(t)};
  const double approach = n.dot(problem.velocity);
  const bool bounces = approach < (configured ? 0 : -2) && problem.restitution > 0;
  const int position_iterations = 4;
  const int iterations = position_iterations + (configured ? 255 : 1);

  Vector3<double> velocity = problem.velocity;
  Vector3<double> impulse{0, 0, 0};  // along the axes
  const auto move = [&](int i, double wanted, double low, double high) {
    const double change = std::clamp(wanted, low, high) - impulse[i];
    impulse[i] += change;
    velocity += problem.k * axes[static_cast<std::size_t>(i)] * change;
  };
  const auto towards = [&](int i, double target, double part) {
    const Vector3<double>& axis = axes[static_cast<std::size_t>(i)];
    return impulse[i] + part * (target - axis.dot(velocity)) / axis.dot(problem.k * axis);
  };
  for (int i = 0; i < iterations && problem.k.trace() > 0; ++i) {
    const bool corrects_depth = !configured && i < position_iterations;
    const double rebound = bounces ? -problem.restitution * approach : corrects_depth ? 0.8 * depth * 60 : 0;
    move(0, towards(0, rebound, 1), 0, INFINITY);
    const double limit = problem.friction * impulse[0];
    if (i > 0) {
      move(1, towards(1, 0, 0.8), -limit, limit);
      move(2, towards(2, 0, 0.8), -limit, limit);
    }
  }
  return outcome_of(collision, impulse[0] * axes[0] + impulse[1] * axes[1] + impulse[2] * axes[2]);
}

}  // namespace carom::formulas
