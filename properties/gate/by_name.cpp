// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/by_name.hpp>

namespace carom::properties {
namespace {

/// The optimal string alignment distance.
std::size_t edits_between(std::string_view x, std::string_view y) {
  std::vector<std::vector<std::size_t>> edits(x.size() + 1, std::vector<std::size_t>(y.size() + 1));
  for (std::size_t i = 0; i <= x.size(); ++i) {
    for (std::size_t j = 0; j <= y.size(); ++j) {
      if (i == 0 || j == 0) {
        edits[i][j] = i + j;
        continue;
      }
      const std::size_t changed = edits[i - 1][j - 1] + (x[i - 1] == y[j - 1] ? 0 : 1);
      edits[i][j] = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1, changed});
      if (i > 1 && j > 1 && x[i - 1] == y[j - 2] && x[i - 2] == y[j - 1]) {
        edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
      }
    }
  }
  return edits[x.size()][y.size()];
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view word, const std::vector<std::string>& names) {
  const std::size_t most = std::min<std::size_t>(2, word.size() / 3);
  std::size_t fewest = most + 1;
  std::optional<std::string> nearest;
  for (const std::string& name : names) {
    const std::size_t difference = std::max(name.size(), word.size()) - std::min(name.size(), word.size());
    if (difference > most) {
      continue;
    }
    const std::size_t edits = edits_between(word, name);
    if (edits < fewest) {
      fewest = edits;
      nearest = name;
    }
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  const std::optional<std::string> nearest = nearest_name(word, names);
  return nearest ? fmt::format("; did you mean '{}'?", *nearest) : std::string();
}

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

namespace {

std::vector<const Family*> chosen_families(const std::vector<std::string>& names) {
  std::vector<const Family*> families = names.empty() ? pointers_to(all_families()) : std::vector<const Family*>();
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
    posed.beyond_domain = pointers_to(families_beyond_domain());
  }
  return posed;
}

}  // namespace carom::properties
