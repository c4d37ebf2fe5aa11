// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::oracles {

/// The state of the contact before the impulse. N is the normal from B to A, and V⁻ is V_A⁻ − V_B⁻ at the contact
/// point.
enum class Approach {
  colliding,   // N·V⁻ < 0 and a body can move
  resting,     // N·V⁻ = 0
  separating,  // N·V⁻ > 0
  inert,       // both bodies immovable
};

/// The approach of a contact with a movable body, from the sign (−1, 0 or 1) of N·V⁻.
[[nodiscard]] constexpr Approach approach_of_sign(int sign) {
  if (sign < 0) {
    return Approach::colliding;
  }
  return sign == 0 ? Approach::resting : Approach::separating;
}

}  // namespace carom::oracles
