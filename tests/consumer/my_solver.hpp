// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdlib>

#include <carom/impulse/contact.hpp>

/// A frictionless solver as in a textbook: j = −(1+ε) N·V / N·K N along the normal N. If `ignores_rotation`, the solver
/// takes the velocities of the centres for those of the contact points, and changes no spin.
inline carom::Outcome<double> textbook(const carom::Collision& collision, bool ignores_rotation) {
  using Vector = Eigen::Vector3d;
  const carom::impulse::Contact<double> contact = carom::impulse::make_contact<double>(collision);
  const auto& [a, b, normal, restitution, friction, tangential_restitution] = contact;
  static_cast<void>(friction + tangential_restitution);  // a textbook's bodies are smooth
  const Vector arm_of_a = ignores_rotation ? Vector(Vector::Zero()) : Vector(a.lever_arm);
  const Vector arm_of_b = ignores_rotation ? Vector(Vector::Zero()) : Vector(b.lever_arm);
  carom::Outcome<double> after{{a.velocity, a.angular_velocity}, {b.velocity, b.angular_velocity}};
  const Vector velocity_of_a = a.velocity + a.angular_velocity.cross(arm_of_a);
  const Vector velocity_of_b = b.velocity + b.angular_velocity.cross(arm_of_b);
  const double approach = normal.dot(velocity_of_a - velocity_of_b);
  const double inverse_mass = a.inverse_mass + b.inverse_mass;
  if (approach >= 0 || inverse_mass == 0) {
    return after;
  }
  const Vector turn_of_a = angular_response(a.inertia, arm_of_a, normal);
  const Vector turn_of_b = angular_response(b.inertia, arm_of_b, normal);
  const Vector response = normal * inverse_mass + turn_of_a.cross(arm_of_a) + turn_of_b.cross(arm_of_b);
  const double j = -(1 + restitution) * approach / normal.dot(response);
  after.a.velocity += normal * (j * a.inverse_mass);
  after.a.angular_velocity += turn_of_a * j;
  after.b.velocity -= normal * (j * b.inverse_mass);
  after.b.angular_velocity -= turn_of_b * j;
  return after;
}

/// The solver that the examples of README.md and docs/guide/conformance.md test. It is wrong if the environment has
/// MY_SOLVER.
inline carom::Outcome<double> my_solver(const carom::Collision& collision) {
  static const bool is_wrong = std::getenv("MY_SOLVER") != nullptr;
  return textbook(collision, is_wrong);
}
