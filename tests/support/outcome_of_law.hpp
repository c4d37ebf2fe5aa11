// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/exact/radical.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/judge/exact_case.hpp>

namespace carom::unit {

[[nodiscard]] inline const oracles::Rational& nearly(const oracles::Rational& x) { return x; }
[[nodiscard]] inline oracles::Rational nearly(const oracles::Radical& x) { return oracles::approximately(x); }

/// The exact outcome of the law; for `coulomb`, the first of its answers. Irrational square roots are rounded, to far
/// more digits than the judge compares.
[[nodiscard]] inline Outcome<oracles::Rational> outcome_of_law(const oracles::ExactCase& exact_case, Law law) {
  const auto rational = []<class T>(const oracles::Truth<T>& truth) {
    return map_outcome<oracles::Rational>(truth.outcome, [](const T& x) { return nearly(x); });
  };
  return law == Law::coulomb ? rational(oracles::coulomb_answers(exact_case).front().truth)
                             : exact_case.with_truth(law, exact_case.state(), rational);
}

/// The exact outcome of the law, rounded to binary64, as a subject reports it. Precondition: the law is one of
/// `laws_with_truth`.
[[nodiscard]] inline ReportedOutcome reported_outcome(const oracles::ExactCase& exact_case, Law law) {
  return {
      map_outcome<long double>(exact_case.nearest_truth(law), [](double x) { return static_cast<long double>(x); })};
}

/// Like reported_outcome, but also with the collision matrix, rounded to binary64.
[[nodiscard]] inline ReportedOutcome reported_outcome_with_matrix(const oracles::ExactCase& exact_case, Law law) {
  ReportedOutcome reported = reported_outcome(exact_case, law);
  reported.collision_matrix = exact_case.collision_matrix().unaryExpr(
      [](const oracles::Rational& x) { return static_cast<long double>(oracles::nearest_double(x)); });
  return reported;
}

}  // namespace carom::unit
