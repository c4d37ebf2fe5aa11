// SPDX-License-Identifier: BSL-1.0
#include <stdexcept>
#include <string>
#include <vector>

#include <carom/properties/gate/deviation.hpp>
#include <carom/properties/gate/nearest_name.hpp>

namespace carom::properties {
namespace {

template <class List>
[[noreturn]] void fail_unknown(const char* kind, const char* plural, std::string_view name, const List& known) {
  std::vector<std::string> names;
  for (const auto& one : known) {
    names.emplace_back(one.name);
  }
  throw std::invalid_argument(std::string("there is no ") + kind + " \"" + std::string(name) + "\"; `carom " + plural +
                              "` lists them" + did_you_mean(name, names));
}

}  // namespace

Deviation deviation_from(std::string_view text) {
  const std::size_t at = text.find('@');
  const std::string_view invariant_name = text.substr(0, at);
  const Invariant* invariant = invariant_named(invariant_name);
  if (invariant == nullptr) {
    fail_unknown("invariant", "invariants", invariant_name, all_invariants());
  }
  if (at == std::string_view::npos) {
    return {invariant, nullptr};
  }
  const std::string_view family_name = text.substr(at + 1);
  const Family* family = family_named(family_name);
  if (family == nullptr) {
    fail_unknown("family", "families", family_name, all_families());
  }
  return {invariant, family};
}

}  // namespace carom::properties
