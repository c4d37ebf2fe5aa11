// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <carom/properties/families/family.hpp>
#include <carom/properties/trial/trial.hpp>

namespace carom::properties {

/// The limit of a subject in a family beyond the claimed domain: the violation at the least value of the family's
/// quantity (`Family::beyond`).
struct Boundary {
  double quantity = 0;
  std::uint64_t index = 0;  // number of the case in its family
  std::string invariant;
};

/// Keeps the boundary with the lesser quantity. If the quantities are equal, it keeps the case with the lesser number.
void keep_if_least(std::optional<Boundary>& kept, const std::optional<Boundary>& other);

/// The boundary that a judged case shows; none if the family has no such quantity, or if nothing is violated.
[[nodiscard]] std::optional<Boundary> boundary_by(const Family& family, std::uint64_t index, const Collision& collision,
                                                  const Judgement& judgement);

}  // namespace carom::properties
