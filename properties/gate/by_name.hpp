// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <carom/properties/cases/domain.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/invariants/invariant.hpp>

namespace carom::properties {

/// The name that a misspelt word probably means: the first name with the fewest edits. An edit adds, removes or changes
/// a letter, or swaps two neighbours. No value if more than two edits are needed, or more than a third of the word's
/// length.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view word, const std::vector<std::string>& names);

/// "; did you mean 'NAME'?", to end an error message. Empty if no name is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

/// An invariant that a subject does not claim.
struct Deviation {
  const Invariant* invariant;
  const Family* family;  // the family in which it is not claimed; nullptr: not claimed in any family
};

/// The deviation that "invariant" or "invariant@family" names. If there is no such invariant or family, throws
/// std::invalid_argument that suggests the nearest name.
[[nodiscard]] Deviation deviation_from(std::string_view text);

struct PosedFamilies {
  std::vector<const Family*> families;
  std::vector<const Family*> without_case;   // the families that have no case within the domain
  std::vector<const Family*> beyond_domain;  // the families beyond the claimed domain; empty unless all is posed
};

/// The family with this name, also if it lies beyond the claimed domain. Throws std::invalid_argument that begins with
/// `option` and suggests the nearest name.
[[nodiscard]] const Family& require_family(const std::string& option, const std::string& name);

/// The families that a run poses: the named ones, each once, or all families if `names` is empty. Throws
/// std::invalid_argument that begins with the option's name if a name is unknown, if no valid case lies within the
/// domain, or if a named family has no case there.
[[nodiscard]] PosedFamilies posed_families(const std::vector<std::string>& names, const Domain& within,
                                           std::uint64_t seed);

}  // namespace carom::properties
