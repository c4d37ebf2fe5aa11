// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <utility>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/contact.hpp>
#include <carom/impulse/select.hpp>

namespace carom::impulse {

/// The result of a law: the impulse F on A and −F on B, and the changes of spin that it causes. No impulse acts if the
/// contact is not colliding.
template <class S>
struct ContactImpulse {
  decltype(std::declval<S>() < std::declval<S>()) colliding;  // a bool, or a mask if S is a pack
  Vector3<S> on_a;                                            // F [N s]; all vectors are meaningless if not colliding
  Vector3<S> change_of_spin_of_a;                             // J_A⁻¹ (r_A × F)
  Vector3<S> change_of_spin_of_b;                             // −J_B⁻¹ (r_B × F)
};

/// The result with the impulse F = `on_a`.
template <class Condition, class S, class Inertia>
[[nodiscard]] ContactImpulse<S> contact_impulse(const Contact<S, Inertia>& contact, const Condition& colliding,
                                                const Vector3<S>& on_a, const ContactMoments<S>& moments) {
  const auto is_any_slender = has_slender(contact);
  const auto change_of_spin = [&](const ContactBody<S, Inertia>& body, const Vector3<S>& on_body,
                                  const Matrix3<S>& of_body) {
    return turning_by_moments(body.inertia, body.lever_arm, on_body, of_body, is_any_slender).change_of_spin;
  };
  return {colliding, on_a, change_of_spin(contact.a, on_a, moments.of_a),
          change_of_spin(contact.b, -on_a, moments.of_b)};
}
template <class Condition, class S, class Inertia>
[[nodiscard]] ContactImpulse<S> contact_impulse(const Contact<S, Inertia>& contact, const Condition& colliding,
                                                const Vector3<S>& on_a) {
  return contact_impulse(contact, colliding, on_a, moments_of_unit_impulses(contact));
}

/// The result itself. The law `rough` has results of another type, and chooses (rough.hpp).
template <class S>
[[nodiscard]] const ContactImpulse<S>& acting_impulse(const ContactImpulse<S>& impulse) {
  return impulse;
}

template <class Condition, class S>
[[nodiscard]] ContactImpulse<S> select(const Condition& condition, const ContactImpulse<S>& yes,
                                       const ContactImpulse<S>& no) {
  return {no.colliding, select(condition, yes.on_a, no.on_a),
          select(condition, yes.change_of_spin_of_a, no.change_of_spin_of_a),
          select(condition, yes.change_of_spin_of_b, no.change_of_spin_of_b)};
}

template <class S, class Inertia>
[[nodiscard]] Outcome<S> apply_impulse(const Contact<S, Inertia>& contact, const ContactImpulse<S>& impulse) {
  const auto after = [&](const ContactBody<S, Inertia>& body, const Vector3<S>& on_body,
                         const Vector3<S>& change_of_spin) {
    return select(impulse.colliding, struck(body, on_body, change_of_spin), unchanged(body));
  };
  return {after(contact.a, impulse.on_a, impulse.change_of_spin_of_a),
          after(contact.b, -impulse.on_a, impulse.change_of_spin_of_b)};
}

}  // namespace carom::impulse
