// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>
#include <vector>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// Two groups of features (feature.hpp). A feature of the first group seldom occurs with one of the second, unless both
/// are chosen.
struct SeldomPair {
  std::vector<const Feature*> first;
  std::vector<const Feature*> second;
};

/// Every such pair of groups. No group is empty.
[[nodiscard]] const std::vector<SeldomPair>& seldom_together();

/// The features whose names begin with this text. Throws std::logic_error if there is none, for example after a feature
/// is renamed.
[[nodiscard]] std::vector<const Feature*> features_beginning(std::string_view beginning);

}  // namespace carom::properties
