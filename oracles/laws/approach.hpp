// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::oracles {

/// The state of the contact before the impulse.
enum class Approach {
  colliding,   // N·V⁻ < 0 and a body can move
  resting,     // N·V⁻ = 0
  separating,  // N·V⁻ > 0
  inert,       // both bodies immovable
};

/// The approach at a contact that has a movable body. `sign` is the sign of N·V⁻: −1, 0 or 1.
[[nodiscard]] constexpr Approach approach_of_sign(int sign) {
  if (sign < 0) {
    return Approach::colliding;
  }
  return sign == 0 ? Approach::resting : Approach::separating;
}

}  // namespace carom::oracles
