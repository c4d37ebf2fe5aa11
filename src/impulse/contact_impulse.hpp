// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <utility>

#include <carom/impulse/contact.hpp>
#include <carom/impulse/select.hpp>

namespace carom::impulse {

/// The result of a law: the impulse F on A and −F on B if the contact is colliding, otherwise no impulse.
template <class S>
struct ContactImpulse {
  decltype(std::declval<S>() < std::declval<S>()) colliding;  // a bool, or a mask if S is a pack
  Vector3<S> on_a;                                            // F [N s]; meaningless if not colliding
};

/// The velocities of one body after the impulse. `on_body` is F for A and −F for B.
template <class Condition, class S, class Inertia, class Slender>
[[nodiscard]] BodyVelocity<S> apply_impulse(const Condition& colliding, const ContactBody<S, Inertia>& body,
                                            const Vector3<S>& on_body, const Slender& has_slender) {
  return select_of_both(
      colliding, [&] { return apply_impulse(body, on_body, has_slender); }, [&] { return unchanged(body); });
}

template <class S, class Inertia>
[[nodiscard]] Outcome<S> apply_impulse(const Contact<S, Inertia>& contact, const ContactImpulse<S>& impulse) {
  const auto is_any_slender = has_slender(contact);
  return {apply_impulse(impulse.colliding, contact.a, impulse.on_a, is_any_slender),
          apply_impulse<decltype(impulse.colliding), S>(impulse.colliding, contact.b, -impulse.on_a, is_any_slender)};
}

}  // namespace carom::impulse
