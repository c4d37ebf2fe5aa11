// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <carom/collision/outcome.hpp>
#include <carom/impulse/contact.hpp>

#include "problem.hpp"

namespace carom::formulas {

/// The settings of Rapier that affect the first contact of two bodies, without gravity.
struct RapierSettings {
  double step;               // World.timestep [s]
  int substeps;              // numSolverIterations
  double natural_frequency;  // contact_natural_frequency [Hz]
  double length_unit;        // lengthUnit [m]
  double overlap;            // the adapter poses shapes with this overlap [m]
};

[[nodiscard]] inline RapierSettings rapier_as_shipped(double overlap) { return {1.0 / 60, 4, 30, 1, overlap}; }
[[nodiscard]] inline RapierSettings rapier_configured(double overlap) { return {1e-16, 4, 0, 1e15, overlap}; }

/// A body that rotates during the substeps. The equations of the contact keep the lever arm and inertia from before the
/// first substep.
class RapierBody {
 public:
  RapierBody(const Body& body, const Vector3<double>& lever_arm) : body_(body), lever_arm_(lever_arm) {
    if (!body.immovable) {
      const Quaternion<double>& q = body.orientation;
      axes_ = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
    }
  }

  /// Applies the gyroscopic torque over `time` t: L = J ω becomes L − t ω × L, scaled back to the old length ‖L‖.
  /// Source: rigid_body.rs, gyroscopic_corrected_angvel.
  void twist(Vector3<double>& angular_velocity, double time) const {
    if (body_.immovable) {
      return;
    }
    const Eigen::Quaterniond axes = rotation_ * axes_;
    const Vector3<double> spin = axes.conjugate() * angular_velocity;
    const Vector3<double> before = body_.principal_inertia.cwiseProduct(spin);
    const Vector3<double> after = before - time * spin.cross(before);
    if (after.squaredNorm() > 0) {
      const Vector3<double> momentum = after * (before.norm() / after.norm());
      angular_velocity = axes * momentum.cwiseQuotient(body_.principal_inertia).eval();
    }
  }

  /// Moves the body, and returns the displacement of its material point at the contact. Source:
  /// RigidBodyVelocity::integrate_linearized.
  [[nodiscard]] Vector3<double> move(const Vector3<double>& velocity, const Vector3<double>& angular_velocity,
                                     double time) {
    const Vector3<double> before = rotation_ * lever_arm_;
    Eigen::Quaterniond change{0, 0, 0, 0};
    change.vec() = time / 2 * angular_velocity;
    rotation_.coeffs() += (change * rotation_).coeffs();
    rotation_.normalize();
    return time * velocity + rotation_ * lever_arm_ - before;
  }

 private:
  Body body_;
  Vector3<double> lever_arm_;
  Eigen::Quaterniond axes_ = Eigen::Quaterniond::Identity();      // principal axes to world, before the first substep
  Eigen::Quaterniond rotation_ = Eigen::Quaterniond::Identity();  // since the first substep
};

/// One contact, as the substeps of Rapier change it.
class RapierContact {
 public:
  RapierContact(const Collision& collision, const RapierSettings& settings)
      : problem_(problem_of(collision)),
        contact_(impulse::make_contact<double>(collision)),
        a_(collision.a, contact_.a.lever_arm),
        b_(collision.b, contact_.b.lever_arm),
        settings_(settings),
        substep_(settings.step / settings.substeps),
        distance_(-settings.overlap) {
    constexpr double damping_ratio = 10;
    const double frequency = 2 * std::numbers::pi * settings.natural_frequency;
    recovery_ = frequency / (substep_ * frequency + 2 * damping_ratio);
    const double compliance = substep_ * recovery_ > 0 ? 1 / (substep_ * recovery_) - 1 : 0;
    softness_ = 1 / (1 + compliance * compliance / ((1 + compliance) * 4 * damping_ratio * damping_ratio));
  }

  void substep() {
    a_.twist(contact_.a.angular_velocity, substep_);
    b_.twist(contact_.b.angular_velocity, substep_);
    apply(pushing_ * problem_.normal + friction_);
    const double recovery = std::clamp(distance_ * recovery_, -3 * settings_.length_unit, 0.0);
    push(distance_ <= 0 ? softness_ : 1, std::max(0.0, distance_) / substep_ + recovery);
    move();
    push(1, std::max(0.0, distance_) / substep_);
    rub();
    has_pushed_ = has_pushed_ || pushing_ > 0;
  }

  void restitute() {
    const double approach = problem_.normal.dot(problem_.velocity);
    if (problem_.restitution > 0 && approach < 0 && has_pushed_) {
      push(1, problem_.restitution * approach);
    }
  }

  [[nodiscard]] Outcome<double> outcome() const { return impulse::unchanged(contact_); }

 private:
  void apply(const Vector3<double>& impulse) {
    const Outcome<double> after = impulse::apply_impulse(contact_, impulse);
    contact_.a.velocity = after.a.velocity;
    contact_.a.angular_velocity = after.a.angular_velocity;
    contact_.b.velocity = after.b.velocity;
    contact_.b.angular_velocity = after.b.angular_velocity;
  }

  void push(double softness, double bias) {
    const Vector3<double>& normal = problem_.normal;
    const double velocity = normal.dot(impulse::relative_velocity(contact_)) + bias;
    const double pushing = softness * std::max(0.0, pushing_ - velocity / normal.dot(problem_.k * normal));
    apply((pushing - pushing_) * normal);
    pushing_ = pushing;
  }

  void rub() {
    Eigen::Matrix<double, 3, 2> tangents;
    tangents.col(0) = problem_.normal.unitOrthogonal();
    tangents.col(1) = problem_.normal.cross(tangents.col(0));
    const Eigen::Matrix2d k = tangents.transpose() * problem_.k * tangents;
    const Eigen::Vector2d slip = tangents.transpose() * impulse::relative_velocity(contact_);
    Vector3<double> friction = friction_ - tangents * (k.inverse() * slip);
    const double limit = problem_.friction * pushing_;
    if (friction.norm() > limit) {
      friction *= limit / friction.norm();
    }
    apply(friction - friction_);
    friction_ = friction;
  }

  void move() {
    for (auto* body : {&contact_.a, &contact_.b}) {
      shorten(body->velocity, 400 * settings_.length_unit);
      shorten(body->angular_velocity, std::numbers::pi / 4 / settings_.step);
    }
    distance_ += problem_.normal.dot(a_.move(contact_.a.velocity, contact_.a.angular_velocity, substep_) -
                                     b_.move(contact_.b.velocity, contact_.b.angular_velocity, substep_));
  }

  Problem problem_;
  impulse::Contact<double> contact_;  // with the current velocities
  RapierBody a_;
  RapierBody b_;
  RapierSettings settings_;
  double substep_;      // [s]
  double distance_;     // gap along N at the contact point; negative if the shapes overlap [m]
  double recovery_;     // erp_inv_dt [1/s]
  double softness_;     // cfm_factor
  double pushing_ = 0;  // the normal impulse of this substep [N s]
  Vector3<double> friction_ = Vector3<double>::Zero();  // the friction of this substep [N s]
  bool has_pushed_ = false;
};

/// The outcome of Rapier. V is the current relative velocity. p and f are the normal impulse and the friction of the
/// substep; they start at 0. Each change of p or f acts on V at once. Each substep has these steps:
///
///  1. Gyroscopic torque changes ω, and the impulse p N + f of the previous substep acts again.
///  2. p ← s max(0, p − (N·V + b) / N·K N). If the shapes overlap, s = softness_ and b = distance_ · recovery_ (at
///     least −3 lengthUnit/s). Otherwise s = 1 and b = g. g is the gap over the substep's time; 0 in an overlap.
///  3. The speeds are clamped to their limits, and the bodies move.
///  4. p ← max(0, p − (N·V + g) / N·K N).
///  5. f ← f − (P K P)⁻¹ P V, P = I − N Nᵀ; if ‖f‖ > μ p, f ← f μ p / ‖f‖.
///
/// After the last substep, if ε > 0, N·V⁻ < 0 and p was positive in some substep:
///
///  p ← max(0, p − (N·V + ε N·V⁻) / N·K N)
///
/// Source: Rapier: staged_island_solver/worker.rs, run_worker; contact_constraint_element.rs, the parts with `Slim` in
/// their names; contact_with_twist_friction.rs, ContactWithTwistFriction::{warmstart, solve} and
/// ContactWithTwistFrictionBuilder::{update, update_rhs_wo_bias, apply_restitution}.
///
/// Precondition: the collision is valid and at least one body can move.
[[nodiscard]] inline Outcome<double> rapier(const Collision& collision, const RapierSettings& settings) {
  RapierContact contact(collision, settings);
  for (int i = 0; i < settings.substeps; ++i) {
    contact.substep();
  }
  contact.restitute();
  return contact.outcome();
}

}  // namespace carom::formulas
