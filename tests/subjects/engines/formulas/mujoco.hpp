// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <limits>

#include <Eigen/Cholesky>

#include "problem.hpp"

namespace carom::formulas {

namespace detail {

inline constexpr double mujoco_step = 0.002;  // as shipped [s]

/// The zero x ≥ 0 of an increasing function, or 0 if the function is not negative at 0. Precondition: the function is
/// not negative for all x ≥ 0.
template <class Function>
[[nodiscard]] double root_of_increasing(const Function& function) {
  if (function(0.0) >= 0) {
    return 0;
  }
  double above = 1;
  while (function(above) < 0) {
    above *= 2;
  }
  while (above > std::numeric_limits<double>::min() && function(above / 2) >= 0) {
    above /= 2;
  }
  double below = above / 2;
  for (double middle = (below + above) / 2; below < middle && middle < above; middle = (below + above) / 2) {
    (function(middle) < 0 ? below : above) = middle;
  }
  return above;
}

/// The impulse F that minimises the cost ½ F·Q F + c·F in the cone ‖F_T‖ ≤ μ F_N, in a basis {N, T0, T1}. For a fixed
/// normal impulse F_N, the Lagrange multiplier ν ≥ 0 of the cone gives the friction F_T of least cost. This least cost
/// is a convex function of F_N, and `impulse` finds the zero of its derivative.
class LeastInCone {
 public:
  LeastInCone(const Matrix3<double>& q, const Vector3<double>& c, double friction)
      : q_(q), c_(c), friction_(friction) {}

  [[nodiscard]] Vector3<double> impulse() const {
    const double along = root_of_increasing([&](double f) { return slope(f); });
    const Eigen::Vector2d across = friction(along, multiplier(along));
    return along > 0 ? Vector3<double>{along, across[0], across[1]} : Vector3<double>::Zero();
  }

 private:
  [[nodiscard]] Eigen::Vector2d friction(double along, double multiplier) const {
    const Eigen::Matrix2d across = q_.bottomRightCorner<2, 2>() + multiplier * Eigen::Matrix2d::Identity();
    return -across.ldlt().solve(c_.tail<2>() + along * q_.col(0).tail<2>());
  }
  [[nodiscard]] double multiplier(double along) const {
    return along > 0 ? root_of_increasing([&](double nu) { return friction_ * along - friction(along, nu).norm(); })
                     : 0;
  }
  /// The derivative of the least cost with respect to F_N. As F_N → 0, ν F_N → ‖c_T‖ / μ.
  [[nodiscard]] double slope(double along) const {
    if (along <= 0) {
      return c_[0] - friction_ * c_.tail<2>().norm();
    }
    const double nu = multiplier(along);
    return c_[0] + q_(0, 0) * along + q_.col(0).tail<2>().dot(friction(along, nu)) - nu * friction_ * friction_ * along;
  }

  Matrix3<double> q_;
  Vector3<double> c_;
  double friction_;
};

/// The impulses f ≥ 0 along the four edges of a pyramid that minimise ½ f·Q f + c·f. Precondition: Q is positive
/// definite.
[[nodiscard]] inline Eigen::Vector4d least_along_edges(const Eigen::Matrix4d& q, const Eigen::Vector4d& c) {
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  double least = 0;
  for (unsigned int set = 1; set < 16; ++set) {
    Eigen::Matrix4d part = Eigen::Matrix4d::Identity();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        if ((set >> i & 1U) != 0 && (set >> j & 1U) != 0) {
          part(i, j) = q(i, j);
        }
      }
      right[i] = (set >> i & 1U) != 0 ? -c[i] : 0;
    }
    const Eigen::Vector4d f = part.ldlt().solve(right);
    const double cost = f.dot(q * f) / 2 + c.dot(f);
    if (f.minCoeff() >= 0 && cost < least) {
      best = f;
      least = cost;
    }
  }
  return best;
}

/// {N, T0, T1} as in MuJoCo: T0 is the world's y axis made orthogonal to N, or the z axis if |N_y| ≥ ½.
[[nodiscard]] inline Matrix3<double> mujoco_frame(const Vector3<double>& n) {
  const Vector3<double> first = n[1] < 0.5 && n[1] > -0.5 ? Vector3<double>::UnitY() : Vector3<double>::UnitZ();
  Matrix3<double> frame;
  frame.col(0) = n;
  frame.col(1) = (first - n.dot(first) * n).normalized();
  frame.col(2) = n.cross(frame.col(1));
  return frame;
}

/// The change of the angular velocity w by gyroscopic torque in one step of length h: −h J⁻¹ (w × J w).
[[nodiscard]] inline Vector3<double> gyroscopic_change(const impulse::ContactBody<double>& body, double step) {
  if (body.inverse_mass == 0) {
    return Vector3<double>::Zero();
  }
  const Vector3<double> spin = body.inertia.axes.transpose() * body.angular_velocity;
  const Vector3<double>& inverse = body.inertia.inverse_moments;
  const Vector3<double> torque = -spin.cross(spin.cwiseQuotient(inverse));
  return step * (body.inertia.axes * torque.cwiseProduct(inverse));
}

/// The collision after one step without a contact, at the original position.
[[nodiscard]] inline Collision after_mujoco_step(const Collision& collision, bool configured) {
  auto velocities = unchanged(collision);
  if (!configured) {
    const auto contact = impulse::make_contact<double>(collision);
    velocities.a.angular_velocity += gyroscopic_change(contact.a, mujoco_step);
    velocities.b.angular_velocity += gyroscopic_change(contact.b, mujoco_step);
  }
  return with_velocities(collision, velocities);
}

/// K, c and R_N of `mujoco_impulse`. K and c are in the basis `frame`, {N, T0, T1}.
struct MujocoProblem {
  Matrix3<double> frame;
  Matrix3<double> k;
  Vector3<double> c;
  double softness;  // R_N
};

[[nodiscard]] inline MujocoProblem mujoco_problem(const Collision& collision, bool configured) {
  const Problem problem = problem_of(collision);
  const Matrix3<double> frame = mujoco_frame(problem.normal);
  const Matrix3<double> k = frame.transpose() * problem.k * frame;
  Vector3<double> c = frame.transpose() * problem.velocity;
  if (configured) {
    constexpr double impedance = 0.9999;
    c[0] *= (1 + problem.restitution) / impedance;
    return {frame, k, c, (1 - impedance) / impedance * k(0, 0)};
  }
  constexpr double impedance = 0.9;
  constexpr double time = 0.95 * 0.02;                                     // [s]
  constexpr double overlap = 64 * std::numeric_limits<double>::epsilon();  // a share of the longer lever arm
  const auto contact = impulse::make_contact<double>(collision);
  const double longer = std::max(contact.a.lever_arm.norm(), contact.b.lever_arm.norm());
  const double depth = overlap * (longer > 0 ? longer : 1);
  const Vector3<double> stepped = problem_of(after_mujoco_step(collision, configured)).velocity;
  c = 2 * mujoco_step / time * c + frame.transpose() * (stepped - problem.velocity);
  c[0] -= mujoco_step * impedance / (time * time) * depth;
  return {frame, k, c, (1 - impedance) / impedance * impulse::inverse_mass(contact)};
}

}  // namespace detail

/// The impulse without friction: the half line F_N ≥ 0 replaces the cone of `mujoco_impulse`.
[[nodiscard]] inline Vector3<double> mujoco_frictionless_impulse(const Collision& collision, bool configured) {
  const detail::MujocoProblem problem = detail::mujoco_problem(collision, configured);
  const double soft = problem.k(0, 0) + problem.softness;
  return problem.frame.col(0) * (problem.c[0] < 0 && soft > 0 ? -problem.c[0] / soft : 0.0);
}

/// The impulse F of MuJoCo 3.14.0. In one step of length h, MuJoCo minimises
///
///  ½ F·(K + R) F + c·F   over the cone ‖F_T‖ ≤ μ F_N,   c = V⁻ + ΔV − V_r.
///
/// R is the softness of the contact. V_r is the requested velocity. ΔV is the change of V in a step without a contact;
/// as shipped, gyroscopic torque causes it. If c_N ≥ μ ‖c_T‖, F = 0. Otherwise, for some ν ≥ 0 that is 0 inside the
/// cone,
///
///  (K + R + ν (P − μ² N Nᵀ)) F = −c,   P = I − N Nᵀ.
///
/// Without R, ΔV and the term μ² N Nᵀ, this equation states the law `coulomb`. The term μ² N Nᵀ leaves V_T⁺ = −ν F_T at
/// a slipping contact point, but makes N·V⁺ = N·V_r + μ ‖V_T⁺‖. So the bodies separate faster than requested, by μ
/// times the slip.
///
/// Configured: h → 0, and V_r = −ε (N·V⁻) N up to softness. With the impedance d = 0.9999,
///
///  c_N = (1+ε) N·V⁻ / d,   c_T = V_T⁻,   R_N = (1−d)/d N·K N,   R_T = R_N / 100.
///
/// At μ = 0, the adapter poses the contact without friction.
///
/// As shipped: h = 0.002 s, and there is no ε. With the depth p of the overlap and τ = 0.95 · 0.02 s,
///
///  c = h b V⁻ + ΔV − h k d p N,   d = 0.9,   b = 2/τ,   k = 1/τ²,   R_N = (1−d)/d (1/m_A + 1/m_B).
///
/// A pyramid with the edges E = N ± μ T0, N ± μ T1 (`mujoco_frame`) replaces the cone: F = Σ f_E E, f_E ≥ 0. The
/// softness of each f_E is 2 μ² (1+μ²) R_N.
///
/// A coefficient μ < 1e-5 acts as 1e-5, except for μ = 0 if configured.
///
/// Source: src/engine/engine_core_constraint.c, `mj_diagApprox` and `mj_makeImpedance` (R, b, k),
/// `mj_referenceConstraint` (V_r) and `mj_constraintUpdate_impl` (the cost, whose dual is the problem above).
/// src/engine/engine_solver.c minimises the cost.
///
/// The formula omits three effects. R_N is at least 1e-15 kg⁻¹, which matters for masses of 1e11 kg or more. d grows
/// with the depth p. As shipped, the solver stops at a tolerance.
[[nodiscard]] inline Vector3<double> mujoco_impulse(const Collision& collision, bool configured) {
  if ((collision.a.immovable && collision.b.immovable) || (configured && collision.friction == 0)) {
    return mujoco_frictionless_impulse(collision, configured);
  }
  const double friction = std::max(1e-5, collision.friction);
  const detail::MujocoProblem problem = detail::mujoco_problem(collision, configured);
  if (configured) {
    const Vector3<double> softness = problem.softness * Vector3<double>{1, 0.01, 0.01};
    const Matrix3<double> soft = problem.k + Matrix3<double>(softness.asDiagonal());
    return problem.frame * detail::LeastInCone(soft, problem.c, friction).impulse();
  }
  Eigen::Matrix<double, 3, 4> edges;
  edges << 1, 1, 1, 1, friction, -friction, 0, 0, 0, 0, friction, -friction;
  const double softness = 2 * friction * friction * (1 + friction * friction) * problem.softness;
  const Eigen::Matrix4d soft = edges.transpose() * problem.k * edges + softness * Eigen::Matrix4d::Identity();
  const Eigen::Vector4d along_edges = detail::least_along_edges(soft, edges.transpose() * problem.c);
  return problem.frame * (edges * along_edges);
}

[[nodiscard]] inline Outcome<double> mujoco(const Collision& collision, bool configured) {
  return outcome_of(detail::after_mujoco_step(collision, configured), mujoco_impulse(collision, configured));
}

}  // namespace carom::formulas
