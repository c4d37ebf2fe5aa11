// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <carom/collision/collision.hpp>

namespace carom::properties {

/// A positive number that a solver may compare with a limit.
struct ComparedQuantity {
  std::string name;                // "the length of the normal"
  double (*of)(const Collision&);  // 0 or less, or not finite, where the collision has none
};

/// What limits are set on: masses, moments and their products, lengths, speeds, ratios; of both bodies the lesser and
/// the greater one.
[[nodiscard]] std::span<const ComparedQuantity> all_compared_quantities();

/// Their decimal logarithms, in that order; NaN where the collision has none. Precondition: it is valid.
[[nodiscard]] std::vector<float> quantities_of(const Collision& collision);

}  // namespace carom::properties
