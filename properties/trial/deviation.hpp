// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <carom/properties/families/family.hpp>
#include <carom/properties/invariants/invariant.hpp>

namespace carom::properties {

/// An invariant that a subject does not claim.
struct Deviation {
  const Invariant* invariant;
  const Family* family;  // in which it is not claimed; nullptr: in none
};

/// What "invariant" or "invariant@family" says. Throws std::invalid_argument where there is no such invariant or
/// family; it names the nearest.
[[nodiscard]] Deviation deviation_from(std::string_view text);

}  // namespace carom::properties
