// SPDX-License-Identifier: BSL-1.0
#include <array>

#include <carom/properties/three_properties.hpp>

namespace carom::properties {

std::span<const Property> three_properties() {
  static const std::array all{
      Property{"non_penetrating_post_velocity",
               "Non-penetrating post-velocity",
               "After the impulse the bodies do not approach at the contact: N·V⁺ ≥ 0.",
               {"non_penetration"}},
      Property{"positive_definiteness",
               "Positive definiteness of C",
               "The collision matrix C of a contact with a movable body is symmetric, and λI ⪯ C with "
               "λ = 1/m_A + 1/m_B > 0. It is the matrix of the solve: C F = V⁺ − V⁻.",
               {"definite", "matrix_used"}},
      Property{"momentum_conservation",
               "Momentum conservation",
               "What one body gains in linear momentum, the other loses. Each body turns by the moment of its impulse, "
               "so the angular momentum about every point is kept.",
               {"linear_momentum", "angular_momentum"}}};
  return all;
}

}  // namespace carom::properties
