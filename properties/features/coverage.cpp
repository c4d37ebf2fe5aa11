// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <charconv>
#include <functional>
#include <system_error>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/properties/features/coverage.hpp>

namespace carom::properties {
namespace {

/// The place of the pair x < y. Those of smaller y come before it.
std::size_t place(std::size_t x, std::size_t y) { return y * (y - 1) / 2 + x; }

constexpr std::size_t pairs_in_digit = 4;

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

FeatureCoverage::FeatureCoverage() : singles_(all_features().size()), pairs_(place(0, all_features().size())) {}

void FeatureCoverage::add(std::span<const std::uint16_t> present) {
  for (auto feature = present.begin(); feature != present.end(); ++feature) {
    ++singles_[*feature];
    for (auto other = present.begin(); other != feature; ++other) {
      pairs_[place(*other, *feature)] = true;
    }
  }
}

std::string FeatureCoverage::pairs() const {
  std::string text((pairs_.size() + pairs_in_digit - 1) / pairs_in_digit, '0');
  for (std::size_t digit = 0; digit < text.size(); ++digit) {
    unsigned value = 0;
    for (std::size_t i = 0; i < pairs_in_digit && digit * pairs_in_digit + i < pairs_.size(); ++i) {
      value |= (pairs_[digit * pairs_in_digit + i] ? 1U : 0U) << i;
    }
    text[digit] = "0123456789abcdef"[value];
  }
  return text;
}

std::optional<FeatureCoverage> FeatureCoverage::reported(std::vector<std::uint64_t> counts, std::string_view pairs) {
  FeatureCoverage coverage;
  if (counts.size() != coverage.singles_.size() || pairs.size() != coverage.pairs().size()) {
    return std::nullopt;
  }
  coverage.singles_ = std::move(counts);
  for (std::size_t digit = 0; digit < pairs.size(); ++digit) {
    unsigned value = 0;
    if (std::from_chars(&pairs[digit], &pairs[digit] + 1, value, 16).ec != std::errc()) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < pairs_in_digit && digit * pairs_in_digit + i < coverage.pairs_.size(); ++i) {
      coverage.pairs_[digit * pairs_in_digit + i] = (value >> i & 1U) != 0;
    }
  }
  return coverage;
}

FeatureCoverage& FeatureCoverage::operator+=(const FeatureCoverage& other) {
  std::transform(singles_.begin(), singles_.end(), other.singles_.begin(), singles_.begin(), std::plus<>());
  std::transform(pairs_.begin(), pairs_.end(), other.pairs_.begin(), pairs_.begin(), std::logical_or<>());
  return *this;
}

bool FeatureCoverage::has_pair(std::size_t x, std::size_t y) const {
  CAROM_EXPECTS(x != y, x);
  return pairs_[place(std::min(x, y), std::max(x, y))];
}

std::uint64_t FeatureCoverage::met_pairs() const {
  return static_cast<std::uint64_t>(std::count(pairs_.begin(), pairs_.end(), true));
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

}  // namespace carom::properties
