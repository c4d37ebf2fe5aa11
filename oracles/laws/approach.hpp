// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::oracles {

/// What happens at the contact.
enum class Approach {
  colliding,   // N·V⁻ < 0 and a body can move
  resting,     // N·V⁻ = 0
  separating,  // N·V⁻ > 0
  inert,       // both bodies immovable
};

/// Of a contact with a movable body, by the sign of N·V⁻: −1, 0 or 1.
[[nodiscard]] constexpr Approach approach_of_sign(int sign) {
  if (sign < 0) {
    return Approach::colliding;
  }
  return sign == 0 ? Approach::resting : Approach::separating;
}

}  // namespace carom::oracles
