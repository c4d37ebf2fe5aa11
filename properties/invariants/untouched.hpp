// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <utility>

#include <carom/properties/invariants/verdicts.hpp>

/// Vectors of an outcome that should be as before the impulse.
namespace carom::properties {

/// One vector of the outcome against the same before the impulse, allowed what the law's sensitivity allows.
[[nodiscard]] inline Verdict vector_untouched(const Evidence& e, OutcomeVector k,
                                              const oracles::Sensitivity& sensitivity) {
  const auto before = unchanged(e.exact_case.bounds().enclosed());
  const auto exact_pair = [&] {
    const auto exactly_before = unchanged(e.exact_case.exact());
    return std::pair{*vectors(e.outcome.exact())[k], *vectors(exactly_before)[k]};
  };
  return vector_equals(*vectors(e.outcome.enclosed())[k], *vectors(before)[k], exact_pair,
                       e.yardstick.allowed(sensitivity[k]), e.yardstick.filtered, name_of(k), "after and before");
}

/// Whether the closeness to the truth, which leaves these vectors untouched, or bounds show that they are so.
[[nodiscard]] inline bool are_surely_untouched(const Evidence& e, std::span<const OutcomeVector> which) {
  if (e.closeness.shows_untouched(which)) {
    count(oracles::Stage::closeness);
    return true;
  }
  return is_surely_untouched(e.exact_case, e.outcome, e.yardstick, which);
}

}  // namespace carom::properties
