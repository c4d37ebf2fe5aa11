// SPDX-License-Identifier: BSL-1.0
#include <carom/collision/expects.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>

namespace carom::oracles {

std::vector<CoulombAnswer> coulomb_answers(const ExactCase& exact_case) {
  if (exact_case.state() == ContactState::colliding) {
    return coulomb_answers(exact_case.exact());
  }
  return {{AnswerKind::untouched, exact_case.truth(Law::frictionless)}};
}

NearestAnswer nearest_answer(const ExactCase& exact_case, const std::vector<CoulombAnswer>& answers,
                             const Outcome<long double>& outcome) {
  CAROM_EXPECTS(!answers.empty() && is_finite(outcome), answers.size());
  const Outcome<Rational> exact = lift(outcome);
  NearestAnswer nearest{0, -HUGE_VAL};
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const double digits = digits_of(exact_case.exact(), answers[i].truth.outcome, exact);
    if (digits > nearest.digits) {
      nearest = {i, digits};
    }
  }
  return nearest;
}

}  // namespace carom::oracles
