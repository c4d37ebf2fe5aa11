// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/solve3_pivoting.hpp>
#include <carom/subjects/methods/scalar_methods.hpp>

namespace carom::subjects {

template <class S>
[[nodiscard]] std::vector<Method> pivoting_methods() {
  return {reflection_method<S, impulse::EigenLdlt>("reflection-ldlt-eigen", "Eigen's LDLT"),
          reflection_method<S, impulse::EigenPartialPivLu>("reflection-partial-lu", "Eigen's PartialPivLU"),
          reflection_method<S, impulse::EigenFullPivLu>("reflection-full-lu", "Eigen's FullPivLU"),
          expected_to_fail(
              reflection_method<S, impulse::EigenColPivHouseholderQr>("reflection-qr", "Eigen's ColPivHouseholderQR"),
              "stable by norms alone: loses the small components where lever arms differ by orders of magnitude")};
}

}  // namespace carom::subjects
