// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/contact.hpp>

namespace carom::impulse {

namespace detail {

/// The contribution of one body to K F.
template <class S, class Inertia, class Condition>
[[nodiscard]] Vector3<S> response(const ContactBody<S, Inertia>& body, const Vector3<S>& impulse,
                                  const Condition& has_slender) {
  return impulse * body.inverse_mass + velocity_by_turning(body.inertia, body.lever_arm, impulse, has_slender);
}

}  // namespace detail

/// K F without forming the collision matrix K: the change of the relative velocity V by the impulse F on A and −F on B.
template <class S, class Inertia>
[[nodiscard]] Vector3<S> response(const Contact<S, Inertia>& contact, const Vector3<S>& impulse) {
  const auto is_any_slender = has_slender(contact);
  return detail::response(contact.a, impulse, is_any_slender) + detail::response(contact.b, impulse, is_any_slender);
}

}  // namespace carom::impulse
