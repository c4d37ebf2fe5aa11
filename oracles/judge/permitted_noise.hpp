// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/judge/yardstick.hpp>
#include <carom/oracles/truths/sensitivity.hpp>

namespace carom::oracles {

/// With `Yardstick::digits`: the error of each vector that passes as rounding. A relative error permits nothing where
/// the exact value is 0, so the noise is `limit_ulps` ulps of the largest speed V in the contact. V is the largest of
/// ‖v⁻‖, ‖w⁻‖ ‖r‖ and ‖w⁻‖ ρ of both bodies, with ρ = √(least moment / m). The noise of w is that of V/ρ, and 0 if the
/// body is immovable. All is 0 without digits. Precondition: the collision is valid.
[[nodiscard]] PerVector<double> permitted_noise(const Collision& collision, const Yardstick& yardstick);

/// Adds `permitted_noise` divided by the allowance to sizes that the allowance multiplies.
void add_permitted_noise(const Collision& collision, const Yardstick& yardstick, PerVector<double>& sizes);

}  // namespace carom::oracles
