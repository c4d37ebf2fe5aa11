// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <limits>

#include <Eigen/LU>

#include "plane_space.hpp"
#include "problem.hpp"

namespace carom::formulas {

/// The x with lower ≤ x ≤ upper for which each component of A x + b is 0, or ≥ 0 with x at its lower bound, or ≤ 0 with
/// x at its upper bound. This linear complementarity problem has one solution, because A is positive definite. The
/// function tries all 27 combinations of these three states.
[[nodiscard]] inline Vector3<double> in_box(const Matrix3<double>& a, const Vector3<double>& b,
                                            const Vector3<double>& lower, const Vector3<double>& upper) {
  Vector3<double> best = Vector3<double>::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int way = 0; way < 27; ++way) {
    const int at[] = {way % 3, way / 3 % 3, way / 9};  // 0 between the bounds, 1 at the lower, 2 at the upper
    Matrix3<double> rows = a;
    Vector3<double> right = -b;
    for (int i = 0; i < 3; ++i) {
      if (at[i] != 0) {
        rows.row(i) = Vector3<double>::Unit(i);
        right[i] = at[i] == 1 ? lower[i] : upper[i];
      }
    }
    if (!right.allFinite()) {
      continue;
    }
    const Vector3<double> x = rows.fullPivLu().solve(right);
    const Vector3<double> rest = a * x + b;
    double violation = 0;
    for (int i = 0; i < 3; ++i) {
      const double outside = std::max(lower[i] - x[i], x[i] - upper[i]) * a(i, i);
      violation = std::max({violation, outside, at[i] == 1 ? -rest[i] : at[i] == 2 ? rest[i] : 0.0});
    }
    if (violation < least) {
      least = violation;
      best = x;
    }
  }
  return best;
}

struct OdeSettings {
  bool pyramid = false;         // dContactApprox1; else μ limits the force [newtons]
  bool along_slip = false;      // dContactFDir1 = V_T⁻/‖V_T⁻‖
  double step = 1.0 / 60.0;     // [s]
  double force_mixing = 1e-10;  // CFM
};

/// The impulse on A of ODE 0.16's dWorldStep on one contact joint, without gyroscopic torque and at depth 0. Source:
/// joints/contact.cpp, lcp.cpp: dSolveLCP.
///
/// The directions are N, s₁ and s₂ = N × s₁. If `along_slip` and V_T⁻ ≠ 0, s₁ = V_T⁻/‖V_T⁻‖, otherwise p of
/// plane_space.hpp. Let A = K + CFM/step in these directions, V⁺ = V⁻ + A F, and w the limit on friction. F is the only
/// solution of
///
///  F_N ≥ 0;  N·V⁺ = −ε N·V⁻, or F_N = 0 and N·V⁺ is greater,
///  |F_s| ≤ w for s = s₁, s₂;  s·V⁺ = 0, or |F_s| = w and F_s opposes s·V⁺.
///
/// If `pyramid`, w is μ times the normal impulse of the problem without friction. ODE does not update this limit.
/// Otherwise, ODE takes μ as a force in newtons, and w = μ · step [N s].
[[nodiscard]] inline Vector3<double> ode_impulse(const Problem& problem, const OdeSettings& settings) {
  const Vector3<double>& n = problem.normal;
  const double approach = n.dot(problem.velocity);
  const Vector3<double> slip = problem.velocity - approach * n;
  const Vector3<double> first = settings.along_slip && !slip.isZero(0) ? slip.normalized() : plane_space(n).p;
  Matrix3<double> basis;
  basis << n, first, n.cross(first);
  Matrix3<double> a = basis.transpose() * problem.k * basis;
  a.diagonal().array() += settings.force_mixing / settings.step;
  Vector3<double> b = basis.transpose() * problem.velocity;
  b[0] += std::min(0.0, problem.restitution * approach);
  const double frictionless = std::max(0.0, -b[0] / a(0, 0));
  const double limit = problem.friction * (settings.pyramid ? frictionless : settings.step);
  const double none = std::numeric_limits<double>::infinity();
  return basis * in_box(a, b, {0, -limit, -limit}, {none, limit, limit});
}

/// The impulse with the settings of the subjects `ode-double-coulomb` and `ode-double-coulomb-as-shipped`.
[[nodiscard]] inline Vector3<double> ode_impulse(const Collision& collision, bool configured) {
  return ode_impulse(problem_of(collision), configured ? OdeSettings{true, true, 1.0 / 60.0, 0} : OdeSettings{});
}

}  // namespace carom::formulas
