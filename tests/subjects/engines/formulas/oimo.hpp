// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>

#include "problem.hpp"

namespace carom::formulas {

/// The outcome of OimoPhysics 1.2.2 for the first contact of two bodies. N is the normal, the index T stands for two
/// directions orthogonal to N in any basis, and V = V⁻ + K F. F starts at 0. The solver repeats 10 times (`configured`:
/// 100 times):
///
///  F_T ← F_T − K_TT⁻¹ V_T,  and if ‖F_T‖ > μ F_N,  F_T ← F_T μ F_N / ‖F_T‖,
///  F_N ← max(0, F_N + (R − V_N) / K_NN).
///
/// Each line updates V. R = −ε V_N⁻ if V_N⁻ < −0.5 m/s (`configured`: V_N⁻ < 0), else 0. The limit μ F_N uses F_N of
/// the previous iteration, which is 0 at first.
///
/// Source: src/oimo/dynamics/constraint/solver/pgs/PgsContactConstraintSolver.hx, `preSolveVelocity` and
/// `solveVelocity`. R is in src/oimo/dynamics/constraint/contact/ContactConstraint.hx, `_getVelocitySolverInfo`.
///
/// The formula omits two effects. As shipped, OimoPhysics limits velocities after the contact to 20 m and π rad per
/// step. A body does not rotate if the product of its principal moments is below 1e-32 (kg m²)³.
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
