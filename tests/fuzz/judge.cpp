// SPDX-License-Identifier: BSL-1.0
// The first byte selects the yardstick. The second byte selects whether numbers keep all digits, and whether the target
// judges relations. Then the case follows, and then the claim and answers of a made-up solver.
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/judge/yardstick.hpp>

#include "agreement.hpp"
#include "case_bytes.hpp"
#include "hard_to_judge.hpp"
#include "target.hpp"

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

/// A subject whose answers come from the input. An answer is the rounded exact outcome moved by some ulps, an outcome
/// at the edge of the permitted rounding, any twelve numbers, a refusal or a skip. The subject reports the exact
/// collision matrix with one changed entry. Each answer reads more of the input, so the input must outlive the subject.
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

/// Whether all finite numbers are 0 or from 2⁻¹⁰⁰ to 2¹⁰⁰ in size. On other numbers, rational arithmetic takes seconds.
bool is_quick_to_judge(const Collision& collision) {
  constexpr double largest = 0x1p+100;
  bool quick = true;
  for_each_number(
      [&](const FieldPath&, const double& number) {
        const double size = std::abs(number);
        quick = quick && (!std::isfinite(size) || size == 0 || (size <= largest && size >= 1 / largest));
      },
      collision);
  return quick;
}

void compare_judges(Bytes bytes) {
  Input input(bytes);
  equality::Agreement agreement;
  agreement.cases = input.byte();  // selects how the yardstick is drawn
  const std::uint8_t choices = input.byte();
  properties::Case one = case_from(input).one;
  if (!is_quick_to_judge(one.collision)) {
    return;
  }
  equality::Examined examined(made_up_subject(input));
  // Judging is slow with all digits, or with relations. So one input in four keeps all digits, and one in four has
  // relations.
  if (choices % 4 != 0) {
    properties::Stream stream = input.stream();
    one = equality::shortened(one, stream);
  }
  const auto relations = choices / 4 % 4 == 0 ? properties::RelationTurn{} : properties::no_relations;
  equality::compare_judges(one, std::span(&examined, 1), relations, "the judges differ", agreement);
  if (!agreement.differences.empty()) {
    fail(agreement.differences + collision_to_json(one.collision).dump());
  }
}

}  // namespace
}  // namespace carom::fuzz

CAROM_FUZZ_TARGET(judge) {
  carom::fuzz::compare_judges({data, size});
  return 0;
}
