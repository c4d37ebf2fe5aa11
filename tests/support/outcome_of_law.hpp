// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/exact/radical.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/judge/exact_case.hpp>

namespace carom::unit {

[[nodiscard]] inline const oracles::Rational& nearly(const oracles::Rational& x) { return x; }
[[nodiscard]] inline oracles::Rational nearly(const oracles::Radical& x) { return oracles::approximately(x); }

/// The exact outcome of the law. For `coulomb`, the first answer. Irrational square roots are rounded far beyond any
/// judged precision.
[[nodiscard]] inline Outcome<oracles::Rational> outcome_of_law(const oracles::ExactCase& exact_case, Law law) {
  const auto rational = []<class T>(const oracles::Truth<T>& truth) {
    return map_outcome<oracles::Rational>(truth.outcome, [](const T& x) { return nearly(x); });
  };
  return law == Law::coulomb ? rational(oracles::coulomb_answers(exact_case).front().truth)
                             : exact_case.with_truth(law, exact_case.approach(), rational);
}

}  // namespace carom::unit
