// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <functional>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/features/infeasible.hpp>

namespace carom::properties {
namespace {

std::size_t place(std::size_t x, std::size_t y) { return std::min(x, y) * all_features().size() + std::max(x, y); }

/// Calls visit(x, y) for every feasible pair of indices x < y.
template <class Visit>
void for_each_feasible_pair(const Visit& visit) {
  const std::size_t count = all_features().size();
  for (std::size_t x = 0; x < count; ++x) {
    for (std::size_t y = x + 1; y < count; ++y) {
      if (is_feasible(x, y)) {
        visit(x, y);
      }
    }
  }
}

/// One feature, or the magnitudes of one quantity. A collision has at most one of these, so it is measured once.
struct FeatureRun {
  std::size_t first;            // place in all_features()
  std::vector<double> decades;  // the limits of the magnitudes, ascending; empty for another feature
};

std::vector<FeatureRun> feature_runs() {
  const std::span<const Feature> all = all_features();
  std::vector<FeatureRun> runs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_magnitude = all[i].kind == FeatureKind::magnitude;
    if (!is_magnitude || i == 0 || all[i].quantity != all[i - 1].quantity) {
      runs.push_back({i, is_magnitude ? std::vector{power_of_ten(all[i].decade)} : std::vector<double>{}});
    }
    if (is_magnitude) {
      CAROM_EXPECTS(runs.back().decades.back() == power_of_ten(all[i].decade), all[i].name);
      runs.back().decades.push_back(power_of_ten(all[i].decade + 1));
    }
  }
  return runs;
}

}  // namespace

FeatureCoverage::FeatureCoverage()
    : singles_(all_features().size()), pairs_(all_features().size() * all_features().size()) {}

void FeatureCoverage::add(std::span<const std::uint16_t> present) {
  for (auto feature = present.begin(); feature != present.end(); ++feature) {
    ++singles_[*feature];
    for (auto other = present.begin(); other != feature; ++other) {
      ++pairs_[place(*other, *feature)];
    }
  }
}

FeatureCoverage FeatureCoverage::reported(std::vector<std::uint64_t> counts, const std::vector<Pair>& missing) {
  CAROM_EXPECTS(counts.size() == all_features().size(), counts.size());
  FeatureCoverage coverage;
  coverage.singles_ = std::move(counts);
  for_each_feasible_pair([&](std::size_t x, std::size_t y) { coverage.pairs_[place(x, y)] = 1; });
  const Feature* first = all_features().data();
  for (const auto& [x, y] : missing) {
    coverage.pairs_[place(static_cast<std::size_t>(x - first), static_cast<std::size_t>(y - first))] = 0;
  }
  return coverage;
}

FeatureCoverage& FeatureCoverage::operator+=(const FeatureCoverage& other) {
  std::transform(singles_.begin(), singles_.end(), other.singles_.begin(), singles_.begin(), std::plus<>());
  std::transform(pairs_.begin(), pairs_.end(), other.pairs_.begin(), pairs_.begin(), std::plus<>());
  return *this;
}

std::uint64_t FeatureCoverage::count(std::size_t x, std::size_t y) const { return pairs_[place(x, y)]; }

std::uint64_t FeatureCoverage::feasible_pairs() const {
  std::uint64_t sum = 0;
  for_each_feasible_pair([&](std::size_t, std::size_t) { ++sum; });
  return sum;
}

std::uint64_t FeatureCoverage::met_pairs() const { return feasible_pairs() - missing_pairs().size(); }

std::vector<FeatureCoverage::Pair> FeatureCoverage::missing_pairs() const {
  std::vector<Pair> missing;
  for_each_feasible_pair([&](std::size_t x, std::size_t y) {
    if (count(x, y) == 0) {
      missing.push_back({&all_features()[x], &all_features()[y]});
    }
  });
  return missing;
}

std::vector<std::uint16_t> feature_places_of(const Collision& collision) {
  static const std::vector<FeatureRun> runs = feature_runs();
  const std::span<const Feature> all = all_features();
  std::vector<std::uint16_t> present;
  for (const auto& [first, decades] : runs) {
    if (decades.empty()) {
      if (all[first].is_present(collision)) {
        present.push_back(static_cast<std::uint16_t>(first));
      }
      continue;
    }
    const auto above = std::upper_bound(decades.begin(), decades.end(), all[first].measure(collision));
    if (above != decades.begin() && above != decades.end()) {
      present.push_back(static_cast<std::uint16_t>(first + static_cast<std::size_t>(above - decades.begin()) - 1));
    }
  }
  return present;
}

std::vector<const Feature*> features_of(const Collision& collision) {
  std::vector<const Feature*> present;
  for (const std::uint16_t place : feature_places_of(collision)) {
    present.push_back(&all_features()[place]);
  }
  return present;
}

bool is_feasible(std::size_t x, std::size_t y) {
  static const std::vector<bool> feasible = [] {
    const std::span<const Feature> all = all_features();
    std::vector<bool> table(all.size() * all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        table[place(i, j)] = why_infeasible(all[i], all[j]).empty();
      }
    }
    return table;
  }();
  return feasible[place(x, y)];
}

}  // namespace carom::properties
