// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/laws/mechanics.hpp>
#include <carom/properties/diagnosis/fits.hpp>

namespace carom::properties::diagnosis {
namespace {

/// The outcomes from + t (to − from).
struct Line {
  Outcome<double> from;
  Outcome<double> to;
};

Outcome<double> at(const Line& line, double t) {
  Outcome<double> outcome;
  for (const OutcomeVector k : all_outcome_vectors) {
    *vectors(outcome)[k] = *vectors(line.from)[k] + t * (*vectors(line.to)[k] - *vectors(line.from)[k]);
  }
  return outcome;
}

/// The parameter t for which the outcome is nearest to the subject's answer, if it is near enough.
std::optional<double> nearest(const std::optional<Line>& line, const KnownCase& one) {
  if (!line) {
    return std::nullopt;
  }
  Outcome<double> step;
  Outcome<double> missing;
  for (const OutcomeVector k : all_outcome_vectors) {
    *vectors(step)[k] = *vectors(line->to)[k] - *vectors(line->from)[k];
    *vectors(missing)[k] = *vectors(one.answered)[k] - *vectors(line->from)[k];
  }
  const double t = energy_product(one.collision, step, missing) / energy_product(one.collision, step, step);
  return std::isfinite(t) && is_explained_by(at(*line, t), one) ? std::optional(t) : std::nullopt;
}

std::optional<Outcome<double>> outcome_of(const Steps& steps, const KnownCase& one) {
  const std::optional<Impulses> impulses = impulses_by(steps, one);
  return impulses ? std::optional(outcome_by(steps, *impulses, one)) : std::nullopt;
}

/// The line between the outcomes for the parameters 0 and 1, which `change` sets in the steps.
template <class Change>
std::optional<Line> line_of(const Steps& steps, const KnownCase& one, const Change& change) {
  Steps none = steps;
  Steps whole = steps;
  change(none, 0.0);
  change(whole, 1.0);
  const std::optional<Outcome<double>> from = outcome_of(none, one);
  const std::optional<Outcome<double>> to = outcome_of(whole, one);
  return from && to ? std::optional(Line{*from, *to}) : std::nullopt;
}

std::optional<double> fitted_factor(const Steps& steps, const KnownCase& one, std::initializer_list<OutcomeVector> of) {
  return nearest(line_of(steps, one,
                         [&](Steps& changed, double t) {
                           for (const OutcomeVector k : of) {
                             changed.factors[k] *= t;
                           }
                         }),
                 one);
}

/// The answer's −N·V⁺ / N·V⁻.
double shown_restitution(const KnownCase& one) {
  const auto approach = [&](const Outcome<double>& motion) {
    return one.collision.normal.dot(oracles::relative_velocity<double>(one.collision, motion));
  };
  return -approach(one.answered) / approach(one.before);
}

std::optional<double> fitted_restitution(const Steps& steps, const KnownCase& one) {
  if (one.approach != oracles::ContactState::colliding) {
    return std::nullopt;
  }
  // The outcome is affine in ε.
  if (is_linear(steps.law)) {
    return nearest(line_of(steps, one,
                           [](Steps& changed, double t) {
                             changed.computed_from.restitution = t;
                             changed.has_right_impulse = false;
                           }),
                   one);
  }
  const double shown = shown_restitution(one);
  return std::isfinite(shown) ? std::optional(shown) : std::nullopt;
}

std::optional<double> fitted_slip(const Steps& steps, const KnownCase& one) {
  if (!has_friction(steps.law) || one.approach != oracles::ContactState::colliding) {
    return std::nullopt;
  }
  return nearest(line_of(steps, one,
                         [](Steps& changed, double t) {
                           changed.friction.stopped *= t;
                           changed.friction.limit = FrictionLimit::none;
                           changed.has_right_impulse = false;
                         }),
                 one);
}

/// The outcome of a linear law is affine in the spins.
std::optional<double> fitted_spins(const Steps& steps, const KnownCase& one) {
  if (!is_linear(steps.law) || one.approach == oracles::ContactState::inert) {
    return std::nullopt;
  }
  return nearest(line_of(steps, one,
                         [](Steps& changed, double t) {
                           changed.computed_from.a.angular_velocity *= t;
                           changed.computed_from.b.angular_velocity *= t;
                           changed.test = ApproachTest::missing;
                           changed.has_right_impulse = false;
                         }),
                 one);
}

/// The answer's ‖F_T‖ / F_n.
std::optional<double> fitted_friction(const Steps& steps, const KnownCase& one) {
  const bool has_cone = steps.law == Law::rough || steps.law == Law::coulomb;
  if (!has_cone || one.approach != oracles::ContactState::colliding) {
    return std::nullopt;
  }
  const Collision& c = one.collision;
  const Vector3<double> impulse = oracles::impulse_on_a(c, one.answered, oracles::reads_impulse_off_a(c));
  const Vector3<double> normal = c.normal.stableNormalized();
  const double ratio = normal.cross(impulse).stableNorm() / normal.dot(impulse);
  return std::isfinite(ratio) && ratio > 0 ? std::optional(ratio) : std::nullopt;
}

/// The quotient of small integers that equals the number, or its first four digits.
std::string in_words(double number) {
  constexpr int most = 9;
  constexpr double nearness = 1e-6;  // two quotients of numbers up to 18 and 9 are further apart: at least 1/72
  for (int divisor = 2; divisor <= most; ++divisor) {
    const double whole = std::round(number * divisor);
    const bool is_whole = std::abs(number - std::round(number)) <= nearness * std::abs(number);
    if (!is_whole && std::abs(whole) <= 2 * most && std::abs(number * divisor - whole) <= nearness * std::abs(whole)) {
      return fmt::format("{:g}/{}", whole, divisor);
    }
  }
  constexpr double readable = 5e-4;
  return number != 1 && std::abs(number - 1) < readable
             ? fmt::format("1 {} {:.2g}", number < 1 ? "−" : "+", std::abs(number - 1))
             : fmt::format("{:.4g}", number);
}

Mistake with_restitution(double (*changed)(double restitution, double number), double number) {
  return [changed, number](Steps& steps, const KnownCase& one) {
    steps.computed_from.restitution = changed(steps.computed_from.restitution, number);
    steps.has_right_impulse = false;
    return one.approach == oracles::ContactState::colliding;
  };
}

}  // namespace

bool agree(double x, double y) {
  constexpr double alike = 0x1p-10;
  return std::abs(x - y) <= alike * std::max(std::abs(x), std::abs(y));
}

bool gives_answer(const FittedLength& length, const Steps& steps, const KnownCase& one) {
  if (!length.value) {
    return fitted(Fit::length_of_impulse, steps, one).has_value();
  }
  const std::optional<Impulses> impulses = steps.is_each_body_alone ? std::nullopt : impulses_by(steps, one);
  if (!impulses) {
    return false;
  }
  const double t = *length.value / impulses->on_a.stableNorm();
  return std::isfinite(t) && is_explained_by(at({one.before, outcome_by(steps, *impulses, one)}, t), one);
}

std::optional<double> fitted(Fit fit, const Steps& steps, const KnownCase& one) {
  using enum OutcomeVector;
  switch (fit) {
    case Fit::factor_of_impulse:
      return fitted_factor(steps, one, {velocity_of_a, angular_velocity_of_a, velocity_of_b, angular_velocity_of_b});
    case Fit::factor_of_spins:
      return fitted_factor(steps, one, {angular_velocity_of_a, angular_velocity_of_b});
    case Fit::factor_of_spin_of_a:
      return fitted_factor(steps, one, {angular_velocity_of_a});
    case Fit::factor_of_spin_of_b:
      return fitted_factor(steps, one, {angular_velocity_of_b});
    case Fit::constant_restitution:
      return fitted_restitution(steps, one);
    case Fit::added_restitution: {
      const std::optional<double> whole = fitted_restitution(steps, one);
      return whole ? std::optional(*whole - steps.computed_from.restitution) : std::nullopt;
    }
    case Fit::factor_of_restitution: {
      const std::optional<double> whole = fitted_restitution(steps, one);
      const double given = steps.computed_from.restitution;
      return whole && given > 0 ? std::optional(*whole / given) : std::nullopt;
    }
    case Fit::spins_before:
      return fitted_spins(steps, one);
    case Fit::stopped_slip:
      return fitted_slip(steps, one);
    case Fit::tangential_part:
      return nearest(line_of(steps, one, [](Steps& changed, double t) { changed.tangential *= t; }), one);
    case Fit::constant_friction:
      return fitted_friction(steps, one);
    case Fit::factor_of_friction: {
      const std::optional<double> whole = fitted_friction(steps, one);
      const double given = steps.computed_from.friction;
      return whole && given > 0 ? std::optional(*whole / given) : std::nullopt;
    }
    case Fit::length_of_impulse:
      break;
  }
  const std::optional<Impulses> impulses = steps.is_each_body_alone ? std::nullopt : impulses_by(steps, one);
  if (!impulses) {
    return std::nullopt;
  }
  const auto t = nearest(Line{one.before, outcome_by(steps, *impulses, one)}, one);
  return t ? std::optional(std::abs(*t) * impulses->on_a.stableNorm()) : std::nullopt;
}

Hypothesis with_number(Fit fit, double number) {
  const std::string words = in_words(number);
  const std::string factor = "factors of the impulse: an extra factor, a relaxation factor, an impulse applied twice";
  const std::string spins = "the change of spin J⁻¹ (r × F): its factors, and the moments of inertia";
  const std::string restitution =
      "the source of the coefficient of restitution: thresholds, defaults, the combination of two coefficients";
  const std::string friction = "the source of μ: its unit, its factors, defaults";
  const auto of = [](std::string as_if, std::string look_at, Mistake mistake) {
    return Hypothesis{std::move(as_if), std::move(look_at), {std::move(mistake)}, {}, true};
  };
  switch (fit) {
    case Fit::factor_of_impulse:
      return of(fmt::format("the impulse were multiplied by {}", words), factor,
                with_factors({number, number, number, number}));
    case Fit::factor_of_spins:
      return of(fmt::format("the changes of both spins were multiplied by {}", words), spins,
                with_factors({1, number, 1, number}));
    case Fit::factor_of_spin_of_a:
      return of(fmt::format("A's change of spin were multiplied by {}", words), spins, with_factors({1, number, 1, 1}));
    case Fit::factor_of_spin_of_b:
      return of(fmt::format("B's change of spin were multiplied by {}", words), spins, with_factors({1, 1, 1, number}));
    case Fit::added_restitution:
      return of(fmt::format("{} were added to ε", words), restitution,
                with_restitution([](double given, double x) { return given + x; }, number));
    case Fit::factor_of_restitution:
      return of(fmt::format("ε were multiplied by {}", words), restitution,
                with_restitution([](double given, double x) { return given * x; }, number));
    case Fit::constant_restitution:
      return of(fmt::format("ε were always {}", words), restitution,
                with_restitution([](double, double x) { return x; }, number));
    case Fit::spins_before:
      return of(fmt::format("the spins in V⁻ were multiplied by {}", words),
                "the term w × r in the velocity of the contact point: its factors, the unit of w",
                computed_as([number](Collision& c) {
                  c.a.angular_velocity *= number;
                  c.b.angular_velocity *= number;
                }));
    case Fit::tangential_part:
      return of(fmt::format("the tangential part of the impulse were multiplied by {}", words),
                "the tangential part of the impulse: its factors and its sign",
                [number](Steps& steps, const KnownCase&) {
                  steps.tangential *= number;
                  return true;
                });
    case Fit::stopped_slip:
      return of(fmt::format("friction stopped {} of the slip that it should", words),
                "the impulse that stops the slip: for a solid sphere 2/7 m ‖V_T‖; its factors, and what resists",
                with_friction([number](FrictionSteps& steps) { steps.stopped *= number; }));
    case Fit::factor_of_friction:
      return of(fmt::format("μ were multiplied by {}", words), friction,
                computed_as([number](Collision& c) { c.friction *= number; }));
    case Fit::constant_friction:
      return of(fmt::format("μ were always {}", words), friction,
                computed_as([number](Collision& c) { c.friction = number; }));
    case Fit::length_of_impulse:
      break;
  }
  return {fmt::format("impulses were limited to {:.4g} N s", number),
          "limits on the impulse",
          {},
          FittedLength{number},
          true};
}

}  // namespace carom::properties::diagnosis
