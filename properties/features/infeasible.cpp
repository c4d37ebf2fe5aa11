// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/properties/features/infeasible.hpp>

namespace carom::properties {
namespace {

/// Runs for all pairs of features and all patterns, so it allocates nothing.
bool matches(std::string_view name, NamePattern pattern, char body) {
  if (pattern.starts_with("X.") || pattern.starts_with("Y.")) {
    const bool is_a = !name.empty() && name[0] == 'a';
    const bool is_b = !name.empty() && name[0] == 'b';
    const bool is_same = body == 0 ? is_a || is_b : (body == 'a') == is_a && is_a != is_b;
    if (pattern[0] == 'X' ? !is_same : is_same || !(is_a || is_b)) {
      return false;
    }
    name.remove_prefix(1);
    pattern.remove_prefix(1);
  }
  return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1)) : name == pattern;
}

std::string_view why_of_magnitudes(const Feature& x, const Feature& y) {
  if (x.quantity == y.quantity) {
    return "a quantity lies in one decade only";
  }
  if (x.quantity == "restitution" && y.quantity == "loss" && x.decade < -1 && y.decade < -1) {
    return "ε and 1 − ε cannot both be below 0.1";
  }
  const bool same_body = x.quantity.substr(0, 2) == y.quantity.substr(0, 2);
  if (same_body && x.quantity.ends_with(".size") && y.quantity.ends_with(".lever_arm") && y.decade > x.decade + 1) {
    return "the contact would lie outside of the body, and K would have no bound";
  }
  return {};
}

std::string_view why_in_order(const Feature& x, const Feature& y) {
  if (x.kind == FeatureKind::magnitude) {
    return y.kind == FeatureKind::magnitude ? why_of_magnitudes(x, y) : std::string_view();
  }
  if (y.kind == FeatureKind::magnitude) {
    for (const Decades& decades : x.limits.only_in) {
      if (matches(y.quantity, decades.quantity, x.body) && (y.decade < decades.low || y.decade > decades.high)) {
        return decades.why;
      }
    }
    return {};
  }
  for (const Exclusion& exclusion : x.limits.never_with) {
    if (std::ranges::any_of(exclusion.features, [&](NamePattern p) { return matches(y.name, p, x.body); })) {
      return exclusion.why;
    }
  }
  const bool are_of_a_kind = x.body == y.body && std::ranges::any_of(x.limits.kinds_of, [&](std::string_view kind) {
                               return std::ranges::find(y.limits.kinds_of, kind) != y.limits.kinds_of.end();
                             });
  return are_of_a_kind ? "at most one of them holds" : "";
}

}  // namespace

std::string_view why_infeasible(const Feature& x, const Feature& y) {
  const std::string_view why = why_in_order(x, y);
  return why.empty() ? why_in_order(y, x) : why;
}

}  // namespace carom::properties
