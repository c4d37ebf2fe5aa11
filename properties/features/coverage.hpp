// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// Counts the features (feature.hpp), and the pairs of features, that colliding contacts had. Other contacts do not
/// count, because no law acts on them. The size of the object does not depend on the number of collisions.
class FeatureCoverage {
 public:
  struct Pair {
    const Feature* x;
    const Feature* y;
  };

  FeatureCoverage();

  /// Adds a collision with the features at these places in all_features(), ascending. Precondition: the collision is
  /// valid and colliding.
  void add(std::span<const std::uint16_t> present);

  /// Restores the coverage from a report, which has the count of each feature and the pairs that no collision had. The
  /// count of any other pair is unknown and becomes 1. Precondition: one count for each feature.
  [[nodiscard]] static FeatureCoverage reported(std::vector<std::uint64_t> counts, const std::vector<Pair>& missing);

  FeatureCoverage& operator+=(const FeatureCoverage& other);

  /// The number of collisions with this feature, given by its place in all_features().
  [[nodiscard]] std::uint64_t count(std::size_t feature) const { return singles_[feature]; }
  [[nodiscard]] std::uint64_t count(std::size_t x, std::size_t y) const;

  /// The number of possible pairs, and of possible pairs that occurred.
  [[nodiscard]] std::uint64_t feasible_pairs() const;
  [[nodiscard]] std::uint64_t met_pairs() const;

  /// The feasible pairs that no collision had, in the order of all_features().
  [[nodiscard]] std::vector<Pair> missing_pairs() const;

 private:
  std::vector<std::uint64_t> singles_;
  std::vector<std::uint64_t> pairs_;  // the pair x < y is at x · (number of features) + y
};

/// The places in all_features() of the features of a valid collision, ascending.
[[nodiscard]] std::vector<std::uint16_t> feature_places_of(const Collision& collision);

/// The features that a valid collision has, in the order of all_features().
[[nodiscard]] std::vector<const Feature*> features_of(const Collision& collision);

/// Whether a collision can have both features, given by their places in all_features(). Caches the results of
/// `why_infeasible`.
[[nodiscard]] bool is_feasible(std::size_t x, std::size_t y);

}  // namespace carom::properties
