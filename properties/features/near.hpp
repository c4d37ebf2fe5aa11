// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <carom/properties/features/feature.hpp>

namespace carom::properties::features {

/// x / y, and 0 if y is 0.
[[nodiscard]] inline double ratio(double x, double y) { return y == 0 ? 0 : x / y; }

/// A feature that nearly holds. `of` names it: "masses_equal", or "moments_equal" for that of A and that of B. The
/// functions get that body, or A if the feature belongs to none.
struct Near {
  const char* of;  // nullptr if the catalogue has no such feature
  /// The relative distance from the feature; 0 if the feature holds, or if the collision cannot have it.
  std::function<double(const Collision&, const Body&)> distance;
  /// Moves a collision that has the feature away from it, by about this distance.
  std::function<void(Stream&, Collision&, Body&, double)> move;
  const char* name = nullptr;       // if it is not "near_" and `of`
  const char* statement = nullptr;  // if `of` is nullptr
};

[[nodiscard]] std::vector<Near> near_bodies();     // orientations, masses, moments
[[nodiscard]] std::vector<Near> near_vectors();    // directions, components and lengths
[[nodiscard]] std::vector<Near> near_relations();  // zero vectors, and fields that nearly agree

/// The near features of these features.
[[nodiscard]] std::vector<Feature> near_features(std::span<const Feature> exact);

}  // namespace carom::properties::features
