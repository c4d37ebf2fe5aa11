// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/contact.hpp>

/// A frictionless solver as in a textbook: j = −(1+ε) N·V / N·K N along the normal N.
inline carom::Outcome<double> textbook(const carom::impulse::Contact<double>& contact) {
  using Vector = Eigen::Vector3d;
  const auto& [a, b, normal, restitution, friction, tangential_restitution] = contact;
  static_cast<void>(friction + tangential_restitution);  // a textbook's bodies are smooth
  carom::Outcome<double> after{{a.velocity, a.angular_velocity}, {b.velocity, b.angular_velocity}};
  const Vector velocity_of_a = a.velocity + a.angular_velocity.cross(a.lever_arm);
  const Vector velocity_of_b = b.velocity + b.angular_velocity.cross(b.lever_arm);
  const double approach = normal.dot(velocity_of_a - velocity_of_b);
  const double inverse_mass = a.inverse_mass + b.inverse_mass;
  if (approach >= 0 || inverse_mass == 0) {
    return after;
  }
  const Vector turn_of_a = angular_response(a.inertia, a.lever_arm, normal);
  const Vector turn_of_b = angular_response(b.inertia, b.lever_arm, normal);
  const Vector response = normal * inverse_mass + turn_of_a.cross(a.lever_arm) + turn_of_b.cross(b.lever_arm);
  const double j = -(1 + restitution) * approach / normal.dot(response);
  after.a.velocity += normal * (j * a.inverse_mass);
  after.a.angular_velocity += turn_of_a * j;
  after.b.velocity -= normal * (j * b.inverse_mass);
  after.b.angular_velocity -= turn_of_b * j;
  return after;
}
