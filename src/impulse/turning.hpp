// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>

namespace carom::impulse {

/// How an impulse F at the lever arm r turns a body: what `turning(inertia, r, F, has_slender)` finds, with the inertia
/// as `PrincipalInertia` or `WorldInertia`. `has_slender`, here and below, is whether a body of the contact is slender:
/// then r × F is formed to its last digits, for both bodies alike; without it the body is taken for the only one.
template <class S>
struct Turning {
  Vector3<S> change_of_spin;  // J⁻¹ (r × F)
  S along_impulse;  // F·(J⁻¹ (r × F) × r) = (r × F)ᵀ J⁻¹ (r × F), how far that moves the contact point along F
};

/// J⁻¹ (r × F): the change of angular velocity by an impulse F [N s] at the lever arm r.
template <class Inertia, class S, class Condition>
[[nodiscard]] Vector3<S> angular_response(const Inertia& inertia, const Vector3<S>& r, const Vector3<S>& impulse,
                                          const Condition& has_slender) {
  return turning(inertia, r, impulse, has_slender).change_of_spin;
}
template <class Inertia, class S>
[[nodiscard]] Vector3<S> angular_response(const Inertia& inertia, const Vector3<S>& r, const Vector3<S>& impulse) {
  return angular_response(inertia, r, impulse, is_slender(inertia));
}

/// (r × F)ᵀ J⁻¹ (r × F): N·([r]ᵀ J⁻¹ [r]) N where F is N.
template <class Inertia, class S>
[[nodiscard]] S angular_part_along(const Inertia& inertia, const Vector3<S>& r, const Vector3<S>& impulse) {
  return turning(inertia, r, impulse, is_slender(inertia)).along_impulse;
}

}  // namespace carom::impulse
