// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <carom/properties/cases/domain.hpp>
#include <carom/properties/cases/family.hpp>

namespace carom::properties {

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
