// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <carom/properties/families/family.hpp>
#include <carom/properties/trial/trial.hpp>

namespace carom::properties {

/// Where a method stops: of the violations in a family beyond the claimed domain, the one at the least of its quantity.
struct Boundary {
  double quantity = 0;
  std::uint64_t index = 0;  // of the case in its family
  std::string invariant;
};

/// Keeps the one at the lesser quantity; of equals that of the lesser number.
void keep_if_least(std::optional<Boundary>& kept, const std::optional<Boundary>& other);

/// What a judged case says of the boundary: nothing if the family has no quantity, or nothing is violated.
[[nodiscard]] std::optional<Boundary> boundary_by(const Family& family, std::uint64_t index, const Collision& collision,
                                                  const Judgement& judgement);

}  // namespace carom::properties
