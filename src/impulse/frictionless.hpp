// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/contact.hpp>

namespace carom::impulse {

/// The frictionless law, F = f N (note eq. 18, for a normal of any length):
///
///   f = −(1+ε) (N·(v_A − v_B) + (w_A·(r_A×N) − w_B·(r_B×N)))
///       / (λ N·N + (r_A×N)ᵀ J_A⁻¹ (r_A×N) + (r_B×N)ᵀ J_B⁻¹ (r_B×N)).
///
/// A contact that is not colliding keeps its velocities. Precondition: the contact was made from a valid collision.
template <class S>
[[nodiscard]] Outcome<S> frictionless(const Contact<S>& contact) {
  const Vector3<S>& n = contact.normal;
  const Vector3<S> torque_arm_a = contact.a.lever_arm.cross(n);
  const Vector3<S> torque_arm_b = contact.b.lever_arm.cross(n);
  const S normal_velocity =
      n.dot(contact.a.velocity - contact.b.velocity) +
      (contact.a.angular_velocity.dot(torque_arm_a) - contact.b.angular_velocity.dot(torque_arm_b));
  if (!is_colliding(contact, normal_velocity)) {
    return unchanged(contact);
  }
  const Vector3<S> spin_a = contact.a.inverse_inertia * torque_arm_a;
  const Vector3<S> spin_b = contact.b.inverse_inertia * torque_arm_b;
  const S inverse_effective_mass = (contact.a.inverse_mass + contact.b.inverse_mass) * n.dot(n) +
                                   (torque_arm_a.dot(spin_a) + torque_arm_b.dot(spin_b));
  const S f = -(S(1) + contact.restitution) * normal_velocity / inverse_effective_mass;
  return apply_impulse<S>(contact, n * f);
}

}  // namespace carom::impulse
