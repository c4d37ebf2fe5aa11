// SPDX-License-Identifier: BSL-1.0
#include "made_up_answers.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/judge/yardstick.hpp>

#include "planted.hpp"

namespace carom::fuzz {
namespace {

ReportedOutcome moved_truth(const oracles::ExactCase& exact_case, Law law, Input& input) {
  Outcome<double> outcome = exact_case.nearest_truth(law);
  const int which = input.byte() % 12;
  const int ulps = input.byte() - 128;
  double& number = (*vectors(outcome)[static_cast<OutcomeVector>(which / 3)])[which % 3];
  number *= 1 + ulps * std::numeric_limits<double>::epsilon();
  return map_outcome<long double>(outcome, [](double x) { return static_cast<long double>(x); });
}

ReportedOutcome any_outcome(Input& input) {
  return map_outcome<long double>(Outcome<long double>{},
                                  [&](long double) { return static_cast<long double>(input.number()); });
}

Matrix3<long double> moved_matrix(const Collision& collision, Precision precision, int place, int ulps) {
  Matrix3<long double> matrix;
  const Matrix3<oracles::Rational> exact = oracles::ExactCase(collision).collision_matrix();
  for (int i = 0; i < 9; ++i) {
    matrix(i / 3, i % 3) = static_cast<long double>(oracles::to_double(exact(i / 3, i % 3)));
  }
  matrix(place / 3, place % 3) *= static_cast<long double>(1 + ulps * unit_roundoff(precision));
  return matrix;
}

Answer made_up_answer(const Collision& collision, Law law, Precision precision, Input& input) {
  const int kind = input.byte() % 16;
  if (kind == 0) {
    return Skipped{"made up"};
  }
  if (kind == 1) {
    return Refused{"made up"};
  }
  if (kind < 5 || !validate(collision).empty()) {
    return any_outcome(input);
  }
  const oracles::ExactCase exact_case(collision);
  if (kind < 10) {
    return moved_truth(exact_case, law, input);
  }
  const double allowance = oracles::default_limit_ulps * unit_roundoff(precision);
  properties::Stream stream = input.stream();
  return equality::planted_outcome(exact_case, law, precision, allowance, stream);
}

}  // namespace

Subject made_up_subject(Input& input) {
  constexpr std::array precisions{Precision::binary32, Precision::binary64, Precision::extended};
  Subject subject;
  subject.name = "made-up";
  subject.law = laws_with_truth.at(input.byte() % laws_with_truth.size());
  subject.precision = precisions.at(input.byte() % precisions.size());
  const Law law = subject.law;
  const Precision precision = subject.precision;
  const int place = input.byte() % 9;
  const int ulps = input.byte() - 128;
  subject.shows_collision_matrix = true;
  subject.open = [=, &input] {
    return Session([=, &input](std::span<const Collision> collisions) {
      std::vector<Answer> answers;
      for (const Collision& collision : collisions) {
        Answer answer = made_up_answer(collision, law, precision, input);
        if (auto* outcome = std::get_if<ReportedOutcome>(&answer); outcome != nullptr && validate(collision).empty()) {
          outcome->collision_matrix = moved_matrix(collision, precision, place, ulps);
        }
        answers.push_back(std::move(answer));
      }
      return answers;
    });
  };
  return subject;
}

}  // namespace carom::fuzz
