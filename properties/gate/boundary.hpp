// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>

#include <carom/properties/cases/family.hpp>
#include <carom/properties/gate/trial.hpp>

namespace carom::properties {

/// A subject's limit in a family beyond the claimed domain: the violation with the least value of `Family::beyond`.
struct Boundary {
  double quantity = 0;
  std::uint64_t index = 0;  // number of the case in its family
  const Invariant* invariant = nullptr;
};

/// Keeps the boundary with the lesser quantity, or with the lesser case number if the quantities are equal.
void keep_if_least(std::optional<Boundary>& kept, const std::optional<Boundary>& other);

/// The boundary that a judged case shows. None if no invariant is violated, or if the family has no `Family::beyond`.
[[nodiscard]] std::optional<Boundary> boundary_by(const Family& family, std::uint64_t index, const Collision& collision,
                                                  const Judgement& judgement);

}  // namespace carom::properties
