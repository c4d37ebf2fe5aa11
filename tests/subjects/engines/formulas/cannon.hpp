// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <carom/collision/outcome.hpp>

#include "problem.hpp"

namespace carom::formulas {

/// The settings of cannon-es that affect one contact of two bodies, without gravity. The contact model SPOOK has the
/// parameters a, b and ε, which contact and friction share. Here, s stands for SPOOK's ε, because ε is the restitution.
struct CannonSettings {
  double a;                 // SPOOK's a: the share of the overlap to remove per second [1/s]
  double b;                 // SPOOK's b: the share of the velocity to remove
  double softness;          // SPOOK's ε, called s here [1/kg]
  double largest_push;      // ContactEquation.maxForce, which limits an impulse [N s]
  double friction_gravity;  // ‖World.frictionGravity‖ [m/s]: μ times this speed times a mass limits an impulse
  int iterations;           // GSSolver.iterations
  double tolerance;         // GSSolver.tolerance [N s]
  double damping;           // linearDamping and angularDamping, the share of the velocity lost per second
  double step;              // [s]
  double overlap;           // the adapter poses shapes with this overlap [m]
};

/// Stiffness 1e7 and relaxation 3. Without gravity, the limit on friction is 0.
[[nodiscard]] inline CannonSettings cannon_as_shipped(double overlap) {
  constexpr double step = 1.0 / 60;
  constexpr double relaxation = 1 + 4 * 3;
  const double softness = 4 / (step * step * 1e7 * relaxation);
  return {4 / (step * relaxation), 12 / relaxation, softness, 1e6, 0, 10, 1e-7, 0.01, step, overlap};
}

/// SPOOK in the limit of infinite relaxation: a = 0, b = 1 and s = 0. The limit on friction is μ times the normal
/// impulse that bodies without rotation would need, (1 + ε) max(0, −N·V⁻) / (1/m_A + 1/m_B).
[[nodiscard]] inline CannonSettings cannon_configured(const Collision& collision, double overlap) {
  const Problem problem = problem_of(collision);
  const double approach = std::max(0.0, -problem.normal.dot(problem.velocity));
  constexpr double none = std::numeric_limits<double>::infinity();
  return {0, 1, 0, none, (1 + problem.restitution) * approach, 100, 0, 0, 1.0 / 60, overlap};
}

/// The impulse F of cannon-es, by Gauss–Seidel on three rows. The directions d of the rows are T_1, T_2, N, in this
/// order. λ_d is the impulse along d:
///
///  T_1 = N × e_x if |N_x| < 0.9, else N × e_y; T_2 = N × T_1. Both have the same length, at most 1.
///  F = λ_1 T_1 + λ_2 T_2 + λ_N N
///  λ_d ← λ_d + (B_d − d·K F − s λ_d) / (d·K d + (1 − d·d) (1/m_A + 1/m_B) + s), clamped to its limits
///  B_d = −b d·V⁻ for T_1 and T_2; B_N = −b (N·V⁻ + ε N·(v_A − v_B)) + a overlap, v of the centres of mass
///  limits: |λ_1|, |λ_2| ≤ μ friction_gravity / (1/m_A + 1/m_B), and 0 ≤ λ_N ≤ maxForce
///
/// Source: cannon-es.js: Narrowphase.createFrictionEquationsFromContact, Vec3.tangents, FrictionEquation.computeB,
/// ContactEquation.computeB, Equation.computeGiMGt (which treats every direction as a unit vector), GSSolver.solve.
[[nodiscard]] inline Vector3<double> cannon_impulse(const Collision& collision, const CannonSettings& settings) {
  struct Row {
    Vector3<double> direction;
    double wanted;
    double least;
    double most;
    double impulse = 0;
  };
  const Problem problem = problem_of(collision);
  const Vector3<double>& normal = problem.normal;
  const Vector3<double> axis = std::abs(normal.x()) < 0.9 ? Vector3<double>::UnitX() : Vector3<double>::UnitY();
  const Vector3<double> tangent = normal.cross(axis);
  const auto inverse_mass = [](const Body& body) { return body.immovable ? 0 : 1 / body.mass; };
  const double inverse_masses = inverse_mass(collision.a) + inverse_mass(collision.b);
  const double bound = problem.friction * settings.friction_gravity / inverse_masses;
  const double between_centres = normal.dot(collision.a.velocity - collision.b.velocity);
  const double asked = normal.dot(problem.velocity) + problem.restitution * between_centres;
  const auto friction_row = [&](const Vector3<double>& direction) -> Row {
    return {direction, -settings.b * direction.dot(problem.velocity), -bound, bound};
  };
  std::array<Row, 3> rows{friction_row(tangent), friction_row(normal.cross(tangent)),
                          Row{normal, settings.a * settings.overlap - settings.b * asked, 0, settings.largest_push}};
  Vector3<double> impulse = Vector3<double>::Zero();
  for (int iteration = 0; iteration < settings.iterations; ++iteration) {
    double changed = 0;
    for (Row& row : rows) {
      const Vector3<double> response = problem.k * row.direction;
      const double missing = row.wanted - response.dot(impulse) - settings.softness * row.impulse;
      const double missing_length = 1 - row.direction.squaredNorm();
      const double mobility = response.dot(row.direction) + missing_length * inverse_masses + settings.softness;
      const double next = row.impulse + missing / mobility;
      const double change = std::clamp(next, row.least, row.most) - row.impulse;
      row.impulse += change;
      impulse += change * row.direction;
      changed += std::abs(change);
    }
    if (changed * changed < settings.tolerance * settings.tolerance) {
      break;
    }
  }
  return impulse;
}

/// The outcome of cannon-es. Each lever arm ends at the surface of its shape, half the overlap beyond the contact
/// point. After the contact, movable bodies are damped (World.internalStep). Precondition: the collision is valid and
/// at least one body can move.
[[nodiscard]] inline Outcome<double> cannon(const Collision& collision, const CannonSettings& settings) {
  Collision posed = collision;
  const Vector3<double> beyond = settings.overlap / 2 * problem_of(collision).normal;
  posed.a.position += beyond;
  posed.b.position -= beyond;
  Outcome<double> outcome = outcome_of(posed, cannon_impulse(posed, settings));
  const double kept = std::pow(1 - settings.damping, settings.step);
  const auto damp = [kept](const Body& body, BodyVelocity<double>& velocity) {
    if (!body.immovable) {
      velocity.velocity *= kept;
      velocity.angular_velocity *= kept;
    }
  };
  damp(collision.a, outcome.a);
  damp(collision.b, outcome.b);
  return outcome;
}

}  // namespace carom::formulas
