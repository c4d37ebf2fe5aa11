// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/properties/trial/trial.hpp>

namespace carom::tool {

/// Why a subject does not claim what is said of the collision matrix.
inline constexpr const char* shows_no_matrix = "as it shows no collision matrix";

/// The names of what a subject does not claim for that reason; none where it shows one.
[[nodiscard]] inline std::vector<std::string> not_claimed_without_matrix(const Subject& subject) {
  std::vector<std::string> names;
  for (const properties::Invariant* invariant : properties::not_claimed_without_matrix(subject)) {
    names.emplace_back(invariant->name);
  }
  return names;
}

}  // namespace carom::tool
