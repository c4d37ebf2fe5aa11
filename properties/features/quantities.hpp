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
  double (*of)(const Collision&);  // not positive or not finite if the collision does not have it
};

/// The name of one of all_compared_quantities().
inline constexpr const char* ratio_of_moments = "a body's greatest moment over its least";

/// The quantities that solvers compare with limits: masses, moments and their products, lengths, speeds, ratios. Most
/// quantities of a body occur twice, as the lesser and the greater of the two bodies.
[[nodiscard]] std::span<const ComparedQuantity> all_compared_quantities();

/// The decimal logarithms of the collision's quantities, in the order of all_compared_quantities(); NaN for a quantity
/// that the collision does not have. Precondition: the collision is valid.
[[nodiscard]] std::vector<float> quantities_of(const Collision& collision);

}  // namespace carom::properties
