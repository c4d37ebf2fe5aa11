// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <utility>

#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {

/// Compares one vector of the outcome with the vector before the impulse. The permitted difference is the allowance
/// times the law's sensitivity.
[[nodiscard]] inline Verdict vector_untouched(const Evidence& e, OutcomeVector k,
                                              const oracles::Sensitivity& sensitivity) {
  const auto before = unchanged(e.exact_case.enclosed());
  const auto exact_pair = [&] {
    const auto exactly_before = unchanged(e.exact_case.exact());
    return std::pair{*vectors(e.outcome.exact())[k], *vectors(exactly_before)[k]};
  };
  return vector_equals(*vectors(e.outcome.enclosed())[k], *vectors(before)[k], exact_pair,
                       e.yardstick.allowed(sensitivity[k]), e.yardstick.filtered(), name_of(k), "after and before");
}

}  // namespace carom::properties
