// SPDX-License-Identifier: BSL-1.0
#include "planted.hpp"

#include <bit>
#include <cmath>
#include <string>

#include <carom/collision/validate.hpp>

#include "support/outcome_of_law.hpp"

namespace carom::equality {
namespace {

long double to_precision(long double number, Precision precision) {
  switch (precision) {
    case Precision::binary32:
      return static_cast<long double>(static_cast<float>(number));
    case Precision::binary64:
      return static_cast<long double>(static_cast<double>(number));
    case Precision::extended:
      break;
  }
  return number;
}

/// The number in extended precision, within one ulp.
long double to_extended(const oracles::Rational& number) {
  const double high = oracles::to_double(number);
  if (!std::isfinite(high)) {
    return static_cast<long double>(high);
  }
  return static_cast<long double>(high) +
         static_cast<long double>(oracles::to_double(number - oracles::Rational(high)));
}

}  // namespace

ReportedOutcome planted_outcome(const oracles::ExactCase& exact_case, Law law, Precision precision, double allowance,
                                properties::Stream& stream) {
  ReportedOutcome outcome = map_outcome<long double>(unit::outcome_of_law(exact_case, law), to_extended);
  const auto k = static_cast<OutcomeVector>(stream.integer(0, 3));
  const double near_the_limit = std::exp2(stream.between(-1, 1));
  const double times = stream.chance(2) ? near_the_limit : near_the_limit * std::exp2(stream.integer(-5, 6));
  const Vector3<double> direction = stream.direction();
  // `coulomb` has no sensitivity, so the sensitivity of `sticking` replaces it.
  const Law like = law == Law::coulomb ? Law::sticking : law;
  const double sensitivity = exact_case.sensitivity(like, allowance)[k];
  if (std::isfinite(sensitivity)) {
    *vectors(outcome)[k] += (direction / direction.norm() * (times * allowance * sensitivity)).cast<long double>();
  }
  return map_outcome<long double>(outcome, [&](long double x) { return to_precision(x, precision); });
}

Subject planting_subject(Law law, Precision precision) {
  Subject subject;
  subject.name = "planted-" + std::string(name_of(law)) + '-' + std::string(name_of(precision));
  subject.law = law;
  subject.precision = precision;
  subject.open = [=] {
    return Session([=](std::span<const Collision> collisions) {
      const double allowance = oracles::default_limit_ulps * unit_roundoff(precision);
      std::vector<Answer> answers;
      for (const Collision& collision : collisions) {
        if (!validate(collision).empty()) {
          answers.emplace_back(Refused{"invalid"});
          continue;
        }
        std::uint64_t state = 0;
        for_each_number([&](const FieldPath&,
                            const double& x) { state = state * 0x100000001b3U ^ std::bit_cast<std::uint64_t>(x); },
                        collision);
        properties::Stream stream = properties::stream_from(state);
        answers.emplace_back(planted_outcome(oracles::ExactCase(collision), law, precision, allowance, stream));
      }
      return answers;
    });
  };
  return subject;
}

}  // namespace carom::equality
