// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/nearest_name.hpp>
#include <carom/properties/gate/posed_families.hpp>

namespace carom::properties {
namespace {

std::vector<const Family*> chosen_families(const std::vector<std::string>& names) {
  std::vector<const Family*> families;
  if (names.empty()) {
    for (const Family& family : all_families()) {
      families.push_back(&family);
    }
  }
  for (const std::string& name : names) {
    const Family* family = &require_family("--families", name);
    if (std::find(families.begin(), families.end(), family) == families.end()) {
      families.push_back(family);
    }
  }
  return families;
}

}  // namespace

const Family& require_family(const std::string& option, const std::string& name) {
  if (const Family* family = family_named(name)) {
    return *family;
  }
  std::vector<std::string> names;
  for (const auto kind : {all_families(), families_beyond_domain()}) {
    for (const Family& known : kind) {
      names.emplace_back(known.name);
    }
  }
  throw std::invalid_argument(fmt::format("{}: there is no family '{}'; expected one of {}{}", option, name,
                                          fmt::join(names, ", "), did_you_mean(name, names)));
}

PosedFamilies posed_families(const std::vector<std::string>& names, const Domain& within, std::uint64_t seed) {
  PosedFamilies posed;
  const auto has_cases = [&](const Family& family) {
    return within.is_everything() || has_cases_within(within, family, seed);
  };
  if (!has_cases(*family_named("generic"))) {
    throw std::invalid_argument(
        fmt::format("--within: no case of generic lies within {}; use wider ranges", to_text(within)));
  }
  for (const Family* family : chosen_families(names)) {
    if (has_cases(*family)) {
      posed.families.push_back(family);
    } else if (names.empty()) {
      posed.without_case.push_back(family);
    } else {
      throw std::invalid_argument(
          fmt::format("--families: no case of {} lies within {}", family->name, to_text(within)));
    }
  }
  if (names.empty() && within.is_everything()) {
    for (const Family& family : families_beyond_domain()) {
      posed.beyond_domain.push_back(&family);
    }
  }
  return posed;
}

}  // namespace carom::properties
