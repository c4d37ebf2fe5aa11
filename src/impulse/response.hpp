// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/contact.hpp>

namespace carom::impulse {

namespace detail {

/// The contribution of one body to K F.
template <class S, class Inertia>
[[nodiscard]] Vector3<S> response(const ContactBody<S, Inertia>& body, const Vector3<S>& impulse) {
  return impulse * body.inverse_mass + velocity_by_turning(body.inertia, body.lever_arm, impulse);
}

}  // namespace detail

/// K F without forming the collision matrix K: the change of the relative velocity V by the impulse F on A and −F on B.
template <class S, class Inertia>
[[nodiscard]] Vector3<S> response(const Contact<S, Inertia>& contact, const Vector3<S>& impulse) {
  return detail::response(contact.a, impulse) + detail::response(contact.b, impulse);
}

}  // namespace carom::impulse
