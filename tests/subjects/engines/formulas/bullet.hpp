// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "plane_space.hpp"
#include "problem.hpp"

namespace carom::formulas {

struct BulletSettings {
  int iterations = 10;
  bool two_directions = false;
  double restitution_threshold = 0.2;  // [m/s]
};

/// The impulse on A of Bullet 3.24's btSequentialImpulseConstraintSolver, without gyroscopic torque and at depth 0.
/// Source: convertContact, setupContactConstraint, setupFrictionConstraint, solveSingleIteration.
///
/// V_T⁻ is the slip before the impulse. The directions are N, s₁ = V_T⁻/‖V_T⁻‖ and, with two directions of friction, s₂
/// = s₁ × N. If ‖V_T⁻‖² ≤ 2⁻⁵² m²/s², s₁ and s₂ are p and q of plane_space.hpp. F starts at 0. Each iteration visits
/// the directions in this order, with V = V⁻ + K F:
///
///  F_N ← max(0, F_N + (e − N·V) / N·KN),   e = −ε N·V⁻, or 0 if −N·V⁻ is below the threshold,
///  F_s ← F_s − s·V / s·Ks, clamped to [−μ F_N, μ F_N]. If F_N = 0, F_s does not change.
[[nodiscard]] inline Vector3<double> bullet_impulse(const Problem& problem, const BulletSettings& settings) {
  const Vector3<double>& n = problem.normal;
  const double approach = n.dot(problem.velocity);
  const Vector3<double> slip = problem.velocity - approach * n;
  std::vector<Vector3<double>> across;
  if (slip.squaredNorm() > std::numeric_limits<double>::epsilon()) {
    across = {slip.normalized(), slip.normalized().cross(n)};
  } else {
    const PlaneSpace plane = plane_space(n);
    across = {plane.p, plane.q};
  }
  across.resize(settings.two_directions ? 2 : 1);
  const bool bounces = -approach >= settings.restitution_threshold;
  const double departure = bounces ? std::max(0.0, -problem.restitution * approach) : 0.0;
  Vector3<double> impulse = Vector3<double>::Zero();
  const auto change_along = [&](const Vector3<double>& d, double wanted) {
    return (wanted - d.dot(problem.velocity + problem.k * impulse)) / d.dot(problem.k * d);
  };
  double pressure = 0;
  for (int i = 0; i < settings.iterations; ++i) {
    const double pushed = std::max(0.0, pressure + change_along(n, departure));
    impulse += (pushed - pressure) * n;
    pressure = pushed;
    if (!(pressure > 0)) {
      continue;
    }
    for (const Vector3<double>& s : across) {
      const double limit = problem.friction * pressure;
      const double before = s.dot(impulse);
      impulse += (std::clamp(before + change_along(s, 0), -limit, limit) - before) * s;
    }
  }
  return impulse;
}

/// The impulse with the settings of the subjects `bullet-double-coulomb` and `bullet-double-coulomb-as-shipped`.
[[nodiscard]] inline Vector3<double> bullet_impulse(const Collision& collision, bool configured) {
  return bullet_impulse(problem_of(collision), configured ? BulletSettings{200, true, 0} : BulletSettings{});
}

}  // namespace carom::formulas
