// SPDX-License-Identifier: BSL-1.0
#include "triples.hpp"

#include <algorithm>

#include <carom/properties/features/coverage.hpp>

namespace carom::properties {
namespace {

std::size_t place(std::size_t x, std::size_t y, std::size_t z) {
  return z * (z - 1) * (z - 2) / 6 + y * (y - 1) / 2 + x;
}

template <class Visit>
void for_each_feasible_triple(const Visit& visit) {
  const std::size_t count = all_features().size();
  for (std::size_t z = 2; z < count; ++z) {
    for (std::size_t y = 1; y < z; ++y) {
      for (std::size_t x = 0; is_feasible(y, z) && x < y; ++x) {
        if (is_feasible(x, y) && is_feasible(x, z)) {
          visit(x, y, z);
        }
      }
    }
  }
}

}  // namespace

TripleCoverage::TripleCoverage() : met_(place(0, 0, all_features().size())) {}

void TripleCoverage::add(const Collision& collision) {
  std::vector<std::size_t> present;
  for (std::size_t z = 0; z < all_features().size(); ++z) {
    if (!all_features()[z].is_present(collision)) {
      continue;
    }
    for (std::size_t j = 0; j < present.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        met_[place(present[i], present[j], z)] = true;
      }
    }
    present.push_back(z);
  }
}

TripleCoverage& TripleCoverage::operator|=(const TripleCoverage& other) {
  std::transform(met_.begin(), met_.end(), other.met_.begin(), met_.begin(), [](bool x, bool y) { return x || y; });
  return *this;
}

std::uint64_t TripleCoverage::met() const {
  std::uint64_t sum = 0;
  for_each_feasible_triple([&](std::size_t x, std::size_t y, std::size_t z) { sum += met_[place(x, y, z)] ? 1 : 0; });
  return sum;
}

std::vector<TripleCoverage::Triple> TripleCoverage::missing() const {
  std::vector<Triple> result;
  for_each_feasible_triple([&](std::size_t x, std::size_t y, std::size_t z) {
    if (!met_[place(x, y, z)]) {
      result.push_back({&all_features()[x], &all_features()[y], &all_features()[z]});
    }
  });
  return result;
}

std::uint64_t TripleCoverage::feasible() {
  std::uint64_t sum = 0;
  for_each_feasible_triple([&](std::size_t, std::size_t, std::size_t) { ++sum; });
  return sum;
}

}  // namespace carom::properties
