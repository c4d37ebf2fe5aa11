// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include <carom/properties/invariant.hpp>

/// How checks make and join verdicts.
namespace carom::properties {

[[nodiscard]] inline Verdict outside_domain(std::string why) {
  return {Status::skipped, 0, 0, std::move(why), {}, {}};
}

[[nodiscard]] inline Verdict verdict_of(oracles::Comparison comparison, const char* what) {
  if (comparison.holds) {
    return {Status::holds, comparison.residual, comparison.allowed, {}, {}, {}};
  }
  return {Status::violated,           comparison.residual,        comparison.allowed, what,
          std::move(comparison.left), std::move(comparison.right)};
}

/// Both must hold: the worse of two verdicts, a violation before a pass before a skip.
[[nodiscard]] inline Verdict both(Verdict first, Verdict second) {
  const auto rank = [](const Verdict& verdict) {
    return verdict.status == Status::violated ? 2 : (verdict.status == Status::holds ? 1 : 0);
  };
  const auto ratio = [](const Verdict& verdict) { return verdict.residual > 0 ? verdict.residual / verdict.allowed : 0; };
  if (rank(first) != rank(second)) {
    return rank(first) > rank(second) ? first : second;
  }
  return ratio(second) > ratio(first) ? second : first;
}

}  // namespace carom::properties
