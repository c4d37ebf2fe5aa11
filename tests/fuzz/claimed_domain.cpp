// SPDX-License-Identifier: BSL-1.0
#include "claimed_domain.hpp"

#include <carom/oracles/filters/moderate.hpp>

namespace carom::fuzz {

bool is_in_claimed_domain(const Collision& collision, Law law) {
  constexpr double largest_ratio_of_moments = 1e8;
  // The collision matrix is K = λI + T, with λ = 1/m_A + 1/m_B and the response to torque T = Σ [r]ᵀ J⁻¹ [r]. So K ⪯ 16
  // λI means T ⪯ 15 λI. This function requires T ⪯ 14.5 λI, so that its rounding errors do not matter.
  constexpr double largest_response_to_torque = 14.5;
  if (!oracles::is_moderate(collision)) {
    return false;
  }
  double inverse_mass = 0;
  double response_to_torque = 0;  // an upper bound of ‖T‖
  for (const Body* body : {&collision.a, &collision.b}) {
    if (body->immovable) {
      continue;
    }
    const double least_moment = body->principal_inertia.minCoeff();
    if (body->principal_inertia.maxCoeff() > largest_ratio_of_moments * least_moment) {
      return false;
    }
    inverse_mass += 1 / body->mass;
    response_to_torque += (collision.point - body->position).squaredNorm() / least_moment;
  }
  return law == Law::frictionless || response_to_torque <= largest_response_to_torque * inverse_mass;
}

}  // namespace carom::fuzz
