// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// The triples of features that occur in the added collisions. A triple counts as feasible if its three pairs are
/// feasible. Some such triples are impossible, so the computed share is a lower bound of the true share.
class TripleCoverage {
 public:
  TripleCoverage();

  /// Preconditions: the collision is valid and colliding.
  void add(const Collision& collision);

  TripleCoverage& operator|=(const TripleCoverage& other);

  [[nodiscard]] std::uint64_t met() const;

  struct Triple {
    const Feature* x;
    const Feature* y;
    const Feature* z;
  };
  /// The triples that did not occur, in the order of the features.
  [[nodiscard]] std::vector<Triple> missing() const;

  [[nodiscard]] static std::uint64_t feasible();

 private:
  std::vector<bool> met_;  // the triple x < y < z at C(z, 3) + C(y, 2) + x
};

}  // namespace carom::properties
