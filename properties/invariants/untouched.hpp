// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <utility>

#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {

/// Compares one vector of the outcome with the vector before the impulse. The permitted difference is the allowance
/// times the law's sensitivity.
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

/// Whether these vectors are certainly unchanged, within the permitted difference. If false, they may still be
/// unchanged.
[[nodiscard]] inline bool are_surely_untouched(const Evidence& e, std::span<const OutcomeVector> which) {
  if (e.closeness.shows_untouched(which)) {
    count(oracles::Stage::closeness);
    return true;
  }
  return is_surely_untouched(e.exact_case, e.outcome, e.yardstick, which);
}

}  // namespace carom::properties
