// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>
#include <vector>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// Two groups of features. A feature of one group seldom occurs with a feature of the other unless both are chosen.
struct SeldomPair {
  std::vector<const Feature*> first;
  std::vector<const Feature*> second;
};

/// All these pairs of groups. No group is empty.
[[nodiscard]] const std::vector<SeldomPair>& seldom_together();

/// The features whose names begin with this text. Throws std::logic_error if there is none.
[[nodiscard]] std::vector<const Feature*> features_beginning(std::string_view beginning);

}  // namespace carom::properties
