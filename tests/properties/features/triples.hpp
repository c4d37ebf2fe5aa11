// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// Which triples of features collisions had. A triple counts as feasible where its three pairs are: no more is known of
/// it, so that what was met is at least this share of what can be.
class TripleCoverage {
 public:
  TripleCoverage();

  /// Precondition: the collision is valid, and colliding.
  void add(const Collision& collision);

  TripleCoverage& operator|=(const TripleCoverage& other);

  [[nodiscard]] std::uint64_t met() const;

  struct Triple {
    const Feature* x;
    const Feature* y;
    const Feature* z;
  };
  /// Those that were not met, in the order of the list.
  [[nodiscard]] std::vector<Triple> missing() const;

  [[nodiscard]] static std::uint64_t feasible();

 private:
  std::vector<bool> met_;  // of x < y < z at C(z, 3) + C(y, 2) + x
};

}  // namespace carom::properties
