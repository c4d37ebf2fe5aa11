// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// Counts the features, and the pairs of features, of colliding contacts. No law acts on other contacts. The memory
/// does not grow with the number of contacts.
class FeatureCoverage {
 public:
  struct Pair {
    const Feature* x;
    const Feature* y;
  };

  FeatureCoverage();

  /// Adds a valid, colliding collision with the features at these indices of all_features(), ascending.
  void add(std::span<const std::uint16_t> present);

  /// Restores the coverage from a report: the count of each feature, and the pairs that did not occur. The count of any
  /// other pair becomes 1. Precondition: one count for each feature.
  [[nodiscard]] static FeatureCoverage reported(std::vector<std::uint64_t> counts, const std::vector<Pair>& missing);

  FeatureCoverage& operator+=(const FeatureCoverage& other);

  /// The arguments are indices in all_features().
  [[nodiscard]] std::uint64_t count(std::size_t feature) const { return singles_[feature]; }
  [[nodiscard]] std::uint64_t count(std::size_t x, std::size_t y) const;

  /// The number of feasible pairs of features, and of those that occurred.
  [[nodiscard]] std::uint64_t feasible_pairs() const;
  [[nodiscard]] std::uint64_t met_pairs() const;

  /// The feasible pairs that did not occur, in the order of all_features().
  [[nodiscard]] std::vector<Pair> missing_pairs() const;

 private:
  std::vector<std::uint64_t> singles_;
  std::vector<std::uint64_t> pairs_;  // the pair x < y is at x · (number of features) + y
};

/// The indices in all_features() of the features of a valid collision, ascending.
[[nodiscard]] std::vector<std::uint16_t> feature_places_of(const Collision& collision);

/// The features of a valid collision, in the order of all_features().
[[nodiscard]] std::vector<const Feature*> features_of(const Collision& collision);

/// Whether a collision can have the features of both indices in all_features(). Caches the results of `why_infeasible`.
[[nodiscard]] bool is_feasible(std::size_t x, std::size_t y);

}  // namespace carom::properties
