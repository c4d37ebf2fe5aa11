// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>
#include <carom/impulse/select.hpp>

namespace carom::impulse {

/// The effect of an impulse F at the lever arm r on the spin of a body. `turning(inertia, r, F, has_slender)` returns
/// it for a `PrincipalInertia` or a `WorldInertia`. `has_slender` is true if a body of the contact is slender. If so,
/// the function for a `PrincipalInertia` computes r × F with a small relative error in each component. Likewise,
/// `velocity_by_turning(inertia, r, F)` returns J⁻¹ (r × F) × r, the velocity that the change of spin adds to the
/// contact point.
template <class S>
struct Turning {
  Vector3<S> change_of_spin;  // J⁻¹ (r × F)
  /// F·u = (r × F)ᵀ J⁻¹ (r × F), with u = `velocity_by_turning`.
  S along_impulse;
};

template <class Condition, class S>
[[nodiscard]] Turning<S> select(const Condition& condition, const Turning<S>& yes, const Turning<S>& no) {
  return {select(condition, yes.change_of_spin, no.change_of_spin),
          select(condition, yes.along_impulse, no.along_impulse)};
}

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

/// (r × F)ᵀ J⁻¹ (r × F), for an impulse F at the lever arm r.
template <class Inertia, class S>
[[nodiscard]] S angular_part_along(const Inertia& inertia, const Vector3<S>& r, const Vector3<S>& impulse) {
  return turning(inertia, r, impulse, is_slender(inertia)).along_impulse;
}

/// The part of one body in the collision matrix, without its mass: [r]ᵀ J⁻¹ [r].
template <class Inertia, class S>
[[nodiscard]] Matrix3<S> angular_part_of_collision_matrix(const Inertia& inertia, const Vector3<S>& r) {
  return angular_part_of_collision_matrix(inertia, r, moments_of_unit_impulses(inertia, r));
}

}  // namespace carom::impulse
