// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>

#include "problem.hpp"

namespace carom::formulas {

/// OimoPhysics 1.2.2, the contact of two bodies that touch for the first time. Let N be the normal, T the two
/// directions across it, in any basis, and V = V⁻ + K F. From F = 0, repeat 10 times (`configured`: 100 times)
///
///   F_T ← F_T − K_TT⁻¹ V_T,  and where ‖F_T‖ > μ F_N,  F_T ← F_T μ F_N / ‖F_T‖,
///   F_N ← max(0, F_N + (R − V_N) / K_NN),
///
/// V being renewed by each line. R = −ε V_N⁻ where V_N⁻ < −0.5 m/s (`configured`: < 0), else 0. The two by two system
/// is solved whole and the limit is a cone, so that the answer does not depend on the basis. Friction comes before the
/// normal impulse, with the limit that the iteration before left: there is none in the first.
///
/// Source: src/oimo/dynamics/constraint/solver/pgs/PgsContactConstraintSolver.hx, `preSolveVelocity` and
/// `solveVelocity`; R in src/oimo/dynamics/constraint/contact/ContactConstraint.hx, `_getVelocitySolverInfo`.
///
/// Left out: the limits of 20 m and π a step on the velocities after it, which `configured` lifts; and that bodies
/// whose principal moments have a product below 1e-32 (kg m²)³ are not turned.
[[nodiscard]] inline Outcome<double> oimo(const Collision& collision, bool configured) {
  const Problem problem = problem_of(collision);
  const Vector3<double>& n = problem.normal;
  Eigen::Matrix<double, 3, 2> t;
  t.col(0) = n.unitOrthogonal();
  t.col(1) = n.cross(t.col(0));
  const Eigen::Matrix2d inverse_across = (t.transpose() * problem.k * t).inverse();
  const double along = n.dot(problem.k * n);
  const double approach = n.dot(problem.velocity);
  const double threshold = configured ? 0 : 0.5;  // [m/s]
  const double rebound = approach < -threshold ? -problem.restitution * approach : 0;
  const int iterations = configured ? 100 : 10;

  double normal_impulse = 0;
  Eigen::Vector2d friction{0, 0};
  const auto impulse = [&]() -> Vector3<double> { return normal_impulse * n + t * friction; };
  const auto velocity = [&]() -> Vector3<double> { return problem.velocity + problem.k * impulse(); };
  for (int i = 0; i < iterations && along > 0; ++i) {
    friction -= inverse_across * (t.transpose() * velocity());
    const double limit = problem.friction * normal_impulse;
    if (friction.norm() > limit) {
      friction *= limit / friction.norm();
    }
    normal_impulse = std::max(0.0, normal_impulse + (rebound - n.dot(velocity())) / along);
  }
  return outcome_of(collision, impulse());
}

}  // namespace carom::formulas
