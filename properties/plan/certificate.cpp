// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/gate/unjudged.hpp>
#include <carom/properties/plan/certificate.hpp>

namespace carom::properties::plan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Greater for a worse failure.
auto badness(const WorstFailure& failure) {
  return std::tuple(failure.result.backward_error.value_or(0), -failure.result.digits.value_or(infinity));
}

bool is_worse(const WorstFailure& x, const WorstFailure& y) {
  return badness(x) != badness(y) ? badness(x) > badness(y) : x.contact < y.contact;
}

template <class Better>
void keep(std::optional<double>& kept, const std::optional<double>& other, const Better& better) {
  if (other) {
    kept = kept ? better(*kept, *other) : *other;
  }
}

double larger(double x, double y) { return std::max(x, y); }
double smaller(double x, double y) { return std::min(x, y); }

/// Every claimed invariant of one outcome.
Claim claim_about_outcome(const Demand& demand) {
  Subject asked;
  asked.law = demand.law;
  Claim claim = claim_of(asked, {demand.limit_ulps, demand.digits});
  std::erase_if(claim.invariants, [](const Invariant* invariant) { return invariant->asks(); });
  return claim;
}

}  // namespace

bool is_less(const Candidate& x, const Candidate& y) {
  // The enumeration `Law` lists the cheapest law first.
  const auto key = [](const Candidate& c) {
    return std::tuple(c.subject.law, c.scalar_rank, c.solve_rank, c.frame, c.subject.name);
  };
  return key(x) < key(y);
}

bool differ_in_precision_alone(const Candidate& x, const Candidate& y) {
  const auto rest = [](const Candidate& c) { return std::tuple(c.subject.law, c.solve, c.frame, c.is_batch); };
  return rest(x) == rest(y) && x.scalar_rank != y.scalar_rank;
}

void Certificate::add(std::size_t contact, const Result& result) {
  Certificate one;
  one.contacts = 1;
  one.worst_backward_error = result.backward_error;
  one.least_digits = result.digits;
  if (!result.failure.empty()) {
    one.failures = 1;
    one.worst = WorstFailure{contact, result};
  }
  *this += one;
}

Certificate& Certificate::operator+=(const Certificate& other) {
  contacts += other.contacts;
  failures += other.failures;
  keep(worst_backward_error, other.worst_backward_error, larger);
  keep(least_digits, other.least_digits, smaller);
  if (other.worst && (!worst || is_worse(*other.worst, *worst))) {
    worst = other.worst;
  }
  return *this;
}

Certifier::Certifier(const Collision& collision, const Demand& demand)
    : demand_(demand),
      judged_({collision, false}),
      ulps_(oracles::Yardstick::of(Precision::binary64, {demand.limit_ulps})),
      claim_(claim_about_outcome(demand)) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  CAROM_EXPECTS(demand.law != Law::any);
}

Result Certifier::judge(const Candidate& candidate, const Answer& answer) const {
  Result result;
  const auto* const reported = std::get_if<ReportedOutcome>(&answer);
  if (reported == nullptr || !oracles::is_finite(*reported)) {
    result.failure = "no finite outcome";
    result.backward_error = determines_outcome(demand_.law) ? std::optional<double>(infinity) : std::nullopt;
    return result;
  }
  const oracles::LiftedOutcome outcome(*reported);
  bool is_allowed = true;
  if (determines_outcome(demand_.law)) {
    const oracles::Accuracy accuracy = oracles::accuracy(exact(), demand_.law, outcome, ulps_);
    if (accuracy.is_decided) {
      is_allowed = accuracy.is_allowed();
      result.backward_error = accuracy.backward_error(ulps_.unit_roundoff());
      result.digits = collides() ? std::optional<double>(accuracy.digits()) : std::nullopt;
    } else if (!exact().is_open(demand_.law, ulps_.allowance())) {
      result.failure = "not decided: the scale overflows or underflows";
      return result;
    }
  } else if (demand_.digits && collides()) {
    result.digits = oracles::nearest_answer(exact(), answers_of_coulomb(), *reported).digits;
  }
  if (!demand_.digits) {
    const oracles::Yardstick of_candidate = oracles::Yardstick::of(candidate.subject.precision, ulps_.limits());
    if (const std::optional<Unjudged> why = reason_unjudged(exact(), of_candidate)) {
      result.failure = in_words(*why);
    } else if (!is_allowed) {
      result.failure = "backward error";
    }
  } else if (collides() && !has_digits(outcome, result)) {
    result.failure = "digits";
  }
  if (result.failure.empty()) {
    result.failure = violated_invariant(answer);
  }
  return result;
}

/// Whether the outcome has the digits asked for, decided exactly. If the allowance is so coarse that the judge accepts
/// the answer of another branch (stick or slip), the printed digits decide, with a margin for rounding.
bool Certifier::has_digits(const oracles::LiftedOutcome& outcome, const Result& result) const {
  constexpr double margin = 0.01;
  if (determines_outcome(demand_.law)) {
    const oracles::Accuracy accuracy = oracles::accuracy(exact(), demand_.law, outcome, claim_.yardstick);
    if (accuracy.is_decided && accuracy.is_of_truth) {
      return accuracy.has_digits.value();
    }
  }
  // If the rounding of the inputs can change the branch, there are no digits, and the outcome passes.
  return !result.digits || *result.digits >= *demand_.digits + margin;
}

std::string Certifier::violated_invariant(const Answer& answer) const {
  for (const NamedVerdict& named : judge_answer(judged_, claim_, lift(answer)).verdicts) {
    if (named.verdict.status == Status::violated) {
      return std::string(named.invariant->name);
    }
  }
  return {};
}

const std::vector<oracles::CoulombAnswer>& Certifier::answers_of_coulomb() const {
  if (!answers_) {
    answers_ = oracles::coulomb_answers(exact());
  }
  return *answers_;
}

}  // namespace carom::properties::plan
