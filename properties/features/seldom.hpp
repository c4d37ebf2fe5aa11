// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>
#include <vector>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// Features that seldom come together unless they are asked for: one of the first with one of the second.
struct SeldomPair {
  std::vector<const Feature*> first;
  std::vector<const Feature*> second;
};

/// Every such pair. Each has a feature on both sides.
[[nodiscard]] const std::vector<SeldomPair>& seldom_together();

/// The features whose names begin so. Throws std::logic_error if there is none: a feature was renamed.
[[nodiscard]] std::vector<const Feature*> features_beginning(std::string_view beginning);

}  // namespace carom::properties
