// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// The number of pairs of features that the colliding cases of a long run have: `carom gate frictionless-double --cases
/// 20000`. Not every pair is possible, so a run is compared with this one.
inline constexpr std::uint64_t pairs_of_long_run = 129492;

/// Counts the features of colliding contacts, and remembers the pairs of features that some contact has. No law acts on
/// other contacts. The memory does not grow with the number of contacts.
class FeatureCoverage {
 public:
  FeatureCoverage();

  /// Adds a valid, colliding collision with the features at these indices of all_features(), ascending.
  void add(std::span<const std::uint16_t> present);

  /// The pairs as a report keeps them, in hexadecimal digits.
  [[nodiscard]] std::string pairs() const;

  /// Restores the coverage from the count of each feature and the result of `pairs`. None if these are not those of
  /// all_features().
  [[nodiscard]] static std::optional<FeatureCoverage> reported(std::vector<std::uint64_t> counts,
                                                               std::string_view pairs);

  FeatureCoverage& operator+=(const FeatureCoverage& other);

  /// The arguments are indices in all_features().
  [[nodiscard]] std::uint64_t count(std::size_t feature) const { return singles_[feature]; }
  /// Whether some contact has both features. Precondition: x ≠ y.
  [[nodiscard]] bool has_pair(std::size_t x, std::size_t y) const;

  /// The number of pairs that some contact has.
  [[nodiscard]] std::uint64_t met_pairs() const;

 private:
  std::vector<std::uint64_t> singles_;
  std::vector<bool> pairs_;  // the pair x < y is at y (y − 1)/2 + x
};

/// The indices in all_features() of the features of a valid collision, ascending.
[[nodiscard]] std::vector<std::uint16_t> feature_places_of(const Collision& collision);

/// The features of a valid collision, in the order of all_features().
[[nodiscard]] std::vector<const Feature*> features_of(const Collision& collision);

}  // namespace carom::properties
