// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <carom/properties/cases/family.hpp>
#include <carom/properties/invariants/invariant.hpp>

namespace carom::properties {

/// An invariant that a subject does not claim.
struct Deviation {
  const Invariant* invariant;
  const Family* family;  // the family in which it is not claimed; nullptr: not claimed in any family
};

/// The deviation that "invariant" or "invariant@family" names. If there is no such invariant or family, throws
/// std::invalid_argument that suggests the nearest name.
[[nodiscard]] Deviation deviation_from(std::string_view text);

}  // namespace carom::properties
