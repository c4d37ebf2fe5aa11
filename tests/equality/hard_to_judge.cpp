// SPDX-License-Identifier: BSL-1.0
#include "hard_to_judge.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include <carom/collision/validate.hpp>

#include "support/known_collisions.hpp"

namespace carom::equality {
namespace {

using properties::Stream;

double scaled(double number, int most, Stream& stream) { return std::ldexp(number, stream.integer(-most, most)); }

/// Replaces each number except μ and e_t by one from `draw`, adjusted to the range of its field.
template <class Draw>
Collision drawn(Collision c, const Draw& draw, Stream& stream) {
  for_each_number(
      [&](const FieldPath& path, double& number) {
        if (path.field == "friction" || path.field == "tangential_restitution") {
          return;
        }
        const double value = stream.chance(12) ? 0 : draw();
        if (path.field == "restitution") {
          number = std::min(1.0, std::abs(value));
        } else if (path.field == "mass" || path.field == "principal_inertia") {
          number = value == 0 ? 1 : std::abs(value);
        } else {
          number = value;
        }
      },
      c);
  return c;
}

double random_bits(Stream& stream) {
  for (;;) {
    const auto number = std::bit_cast<double>(stream.bits());
    if (std::isfinite(number)) {
      return number;
    }
  }
}

/// The collision with each field scaled by its own power of two, from 2^−most to 2^most.
Collision scaled_fields(Collision c, int most, Stream& stream) {
  const auto factor = [&] { return scaled(1, most, stream); };
  for (Body* body : {&c.a, &c.b}) {
    body->mass *= factor();
    body->principal_inertia *= factor();
    body->orientation *= factor();
    body->position *= factor();
    body->velocity *= factor();
    body->angular_velocity *= factor();
  }
  c.point *= factor();
  c.normal *= factor();
  return c;
}

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

}  // namespace

properties::Case shortened(properties::Case one, Stream& stream) {
  constexpr int largest_exponent = 6;
  const int digits = stream.integer(1, 12);
  for_each_number(
      [&](const FieldPath&, double& number) {
        int exponent = 0;
        const double significand = std::frexp(number, &exponent);
        number = std::ldexp(std::nearbyint(std::ldexp(significand, digits)),
                            std::clamp(exponent, -largest_exponent, largest_exponent) - digits);
      },
      one.collision);
  one.collision.b.immovable = one.collision.b.immovable || stream.chance(2);
  one.convex_uniform = false;
  return one;
}

properties::Case wild_case(Stream& stream) {
  const auto families = properties::all_families();
  // Extreme cases are rare, because each may take the rational judge seconds.
  constexpr std::array moderate{4, 8, 16, 40};
  constexpr std::array extreme{100, 200, 300, 1000};
  for (;;) {
    const properties::Family& family =
        families[static_cast<std::size_t>(stream.integer(0, static_cast<int>(families.size()) - 1))];
    properties::Case one = family.generate(stream);
    one.convex_uniform = false;
    const bool is_extreme = stream.chance(64);
    const int most = (is_extreme ? extreme : moderate).at(static_cast<std::size_t>(stream.integer(0, 3)));
    switch (stream.integer(0, is_extreme ? 3 : 2)) {
      case 0:
      case 1:
        one.collision = scaled_fields(one.collision, most, stream);
        break;
      case 2:
        one.collision = drawn(
            one.collision, [&] { return scaled(stream.signed_unit(), most, stream); }, stream);
        break;
      default:
        one.collision = drawn(
            one.collision, [&] { return random_bits(stream); }, stream);
    }
    if (validate(one.collision).empty()) {
      return one;
    }
  }
}

ReportedOutcome planted_outcome(const oracles::ExactCase& exact_case, Law law, Precision precision, double allowance,
                                properties::Stream& stream) {
  ReportedOutcome outcome = map_outcome<long double>(unit::outcome_of_law(exact_case, law), unit::to_extended);
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
