// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

/// Read this first: what every collision response has to have, whatever its law.
namespace carom::properties {

/// One of the three properties.
struct Property {
  std::string_view name;       // a key: lower case, with underscores
  std::string_view title;      // in words
  std::string_view statement;  // one sentence
  /// The invariants that judge it, by their names in the catalogue. Their theorems are the property's
  /// (`Proof`, invariants/proof.hpp).
  std::vector<std::string_view> invariants;
};

/// Non-penetrating post-velocity, positive definiteness of C, and conservation of momentum.
[[nodiscard]] std::span<const Property> three_properties();

}  // namespace carom::properties
