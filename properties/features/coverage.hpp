// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// Which features, and which pairs of them, collisions had. Where nothing collides no law acts, so those are left out.
/// Its size does not depend on how many were added.
class FeatureCoverage {
 public:
  struct Pair {
    const Feature* x;
    const Feature* y;
  };

  FeatureCoverage();

  /// `present`: the places of its features. Precondition: the collision is valid, and colliding.
  void add(std::span<const std::uint16_t> present);

  /// Of what a report says: how many collisions had each feature, and which pairs none had. How many had a pair is not
  /// known: one is counted. Precondition: a count for each feature.
  [[nodiscard]] static FeatureCoverage reported(std::vector<std::uint64_t> counts, const std::vector<Pair>& missing);

  FeatureCoverage& operator+=(const FeatureCoverage& other);

  /// Collisions that had this feature, by its place in all_features().
  [[nodiscard]] std::uint64_t count(std::size_t feature) const { return singles_[feature]; }
  [[nodiscard]] std::uint64_t count(std::size_t x, std::size_t y) const;

  /// Pairs that can be, and those of them that were.
  [[nodiscard]] std::uint64_t feasible_pairs() const;
  [[nodiscard]] std::uint64_t met_pairs() const;

  /// The feasible pairs that no collision had, in the order of the list.
  [[nodiscard]] std::vector<Pair> missing_pairs() const;

 private:
  std::vector<std::uint64_t> singles_;
  std::vector<std::uint64_t> pairs_;  // of x < y at x · features + y
};

/// The places in all_features() of those that a valid collision has, ascending.
[[nodiscard]] std::vector<std::uint16_t> feature_places_of(const Collision& collision);

/// The features that a valid collision has, in the order of the list.
[[nodiscard]] std::vector<const Feature*> features_of(const Collision& collision);

/// Whether a collision can have both, by their places in all_features(): `why_infeasible`, remembered.
[[nodiscard]] bool is_feasible(std::size_t x, std::size_t y);

}  // namespace carom::properties
