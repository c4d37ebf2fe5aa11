// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/laws/mechanics.hpp>
#include <carom/properties/diagnosis/fits.hpp>

namespace carom::properties::diagnosis {
namespace {

using Number = std::optional<double>;

Outcome<double> difference(const Outcome<double>& x, const Outcome<double>& y) {
  Outcome<double> result;
  for (const OutcomeVector k : all_outcome_vectors) {
    *vectors(result)[k] = *vectors(x)[k] - *vectors(y)[k];
  }
  return result;
}

/// The number for which the outcome is the subject's answer, by the secant method from two numbers. `outcome_at` has no
/// value where the number does not apply.
template <class OutcomeAt>
Number found_from(double from, double to, const OutcomeAt& outcome_at, const KnownCase& one) {
  std::optional<Outcome<double>> last = outcome_at(from);
  std::optional<Outcome<double>> now = outcome_at(to);
  constexpr int most_steps = 12;
  constexpr double rounding = 0x1p-34;
  double distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_steps && last && now; ++i) {
    const Outcome<double> step = difference(*now, *last);
    const double share =
        energy_product(one.collision, step, difference(one.answered, *now)) / energy_product(one.collision, step, step);
    const double next = to + share * (to - from);
    if (!std::isfinite(next)) {
      break;
    }
    const bool is_last = std::abs(next - to) <= rounding * std::abs(next);
    from = std::exchange(to, next);
    last = std::exchange(now, outcome_at(to));
    if (is_last || !now) {
      break;
    }
    constexpr int patience = 3;
    const double distance_now = energy_distance(one.collision, *now, one.answered);
    if (i % patience == patience - 1) {
      if (!(distance_now < distance / 2)) {
        break;
      }
      distance = distance_now;
    }
  }
  return now && is_explained_by(*now, one) ? Number(to) : std::nullopt;
}

// The starts of a search, in units of the quantity.
constexpr std::array first_factors{-1.0, 0.02, 0.2, 0.5, 2.0, 5.0, 57.0};
constexpr std::array additions{0.001, 0.03, 0.3, 3.0};
constexpr std::array coefficients{0.5};
constexpr std::array least_values{1.2, 2.0, 1e1, 1e2, 1e3, 1e5, 1e8};
constexpr std::array most_values{0.8, 0.3, 0.1, 1e-2, 1e-3, 1e-4};

const std::array<std::pair<const char*, std::array<bool, 2>>, 3> whose{
    {{"both bodies", {true, true}}, {"A", {true, false}}, {"B", {false, true}}}};

std::string with_name(std::string text, const char* name) {
  if (const std::size_t place = text.find("[]"); place != std::string::npos) {
    text.replace(place, 2, name);
  }
  return text;
}

/// Factors of a quantity of one body or both.
void add_factors_of_bodies(std::vector<Fit>& all) {
  struct Quantity {
    const char* as_if;  // `[]` stands for the bodies
    const char* look_at;
    bool is_of_immovable;
    std::vector<Use> uses;
    void (*change)(Body&, const Vector3<double>& point, double factor);
  };
  using enum Use;
  static const Quantity quantities[]{
      {"the mass of [] were multiplied by {}",
       "the mass: its factors",
       false,
       {everywhere, computation, application},
       [](Body& b, const Vector3<double>&, double t) { b.mass *= t; }},
      {"the moments of [] were multiplied by {}",
       "the moments of inertia: their factors and units",
       false,
       {everywhere, application},
       [](Body& b, const Vector3<double>&, double t) { b.principal_inertia *= t; }},
      {"the angular term of [] in the collision matrix K were multiplied by {}",
       "the term −[r] J⁻¹ [r] of K: its factors, the moments, and the lever arm, whose factor counts twice",
       false,
       {computation},
       [](Body& b, const Vector3<double>&, double t) { b.principal_inertia /= t; }},
      {"the spin of [] in V⁻ were multiplied by {}",
       "the term w × r in the velocity of the contact point: its factors, the unit of w",
       true,
       {computation},
       [](Body& b, const Vector3<double>&, double t) { b.angular_velocity *= t; }},
      {"the velocity of [] in V⁻ were multiplied by {}",
       "the relative velocity: the factors of v",
       true,
       {computation},
       [](Body& b, const Vector3<double>&, double t) { b.velocity *= t; }},
      {"the lever arm of [] were multiplied by {}",
       "the lever arm r = P − X: its factors",
       true,
       {everywhere, computation},
       [](Body& b, const Vector3<double>& point, double t) { b.position = point - t * (point - b.position); }},
  };
  for (const Quantity& quantity : quantities) {
    for (const Use use : quantity.uses) {
      for (const auto& [name, is_meant] : whose) {
        const bool is_of_motion = quantity.uses.size() == 1;
        all.push_back({with_name(quantity.as_if, name) + (is_of_motion ? "" : words_of(use)), quantity.look_at,
                       [&quantity, use, meant = is_meant](Steps& steps, const KnownCase& one, double factor) {
                         return misread_in(use, [&](Collision& c) {
                           for (const bool is_a : {true, false}) {
                             Body& body = is_a ? c.a : c.b;
                             if (meant[is_a ? 0 : 1] && (!body.immovable || quantity.is_of_immovable)) {
                               quantity.change(body, c.point, factor);
                             }
                           }
                         })(steps, one);
                       },
                       use == everywhere || use == application});
      }
    }
  }
}

/// A factor of the steps themselves.
Fit factor_of(const char* as_if, const char* look_at, void (*change)(Steps&, double), bool changes_application) {
  return {as_if, look_at,
          [change](Steps& steps, const KnownCase&, double t) {
            change(steps, t);
            return true;
          },
          changes_application};
}

void add_factors_of_impulse(std::vector<Fit>& all) {
  const char* const impulse = "factors of the impulse: an extra factor, a relaxation factor, an impulse applied twice";
  const char* const spins = "the change of spin J⁻¹ (r × F): its factors, and the moments of inertia";
  const auto add = [&](const char* as_if, const char* look_at, void (*change)(Steps&, double), bool applied) {
    all.push_back(factor_of(as_if, look_at, change, applied));
  };
  const auto add_of_outcome = [&](const char* as_if, PerVector<bool> of) {
    all.push_back({as_if, spins, [of](Steps& steps, const KnownCase&, double t) {
                     for (const OutcomeVector k : all_outcome_vectors) {
                       steps.factors[k] *= of[k] ? t : 1;
                     }
                     return true;
                   }});
  };
  add(
      "the impulse were multiplied by {}", impulse,
      [](Steps& steps, double t) {
        steps.normal *= t;
        steps.tangential *= t;
      },
      false);
  add_of_outcome("the changes of both spins were multiplied by {}", {false, true, false, true});
  add_of_outcome("A's change of spin were multiplied by {}", {false, true, false, false});
  add_of_outcome("B's change of spin were multiplied by {}", {false, false, false, true});
  add(
      "the normal part of the impulse were multiplied by {}", "the normal part of the impulse: its factors",
      [](Steps& steps, double t) { steps.normal *= t; }, false);
}

double shown_friction(const KnownCase& one) {
  const Collision& c = one.collision;
  const Vector3<double> impulse = oracles::impulse_on_a(c, one.answered, oracles::reads_impulse_off_a(c));
  const Vector3<double> normal = c.normal.stableNormalized();
  return normal.cross(impulse).stableNorm() / normal.dot(impulse);
}

/// ε, μ and e_t: numbers in their place, added to them, or their factors. A fit applies to contacts that collide.
void add_coefficients(std::vector<Fit>& all) {
  const char* const restitution =
      "the source of the coefficient of restitution: thresholds, defaults, the combination of two coefficients";
  const char* const friction = "the source of μ: its unit, its factors, defaults";
  const auto of = [&](const char* as_if, const char* look_at, bool is_of_cone, auto change) -> Fit& {
    all.push_back({as_if, look_at,
                   [=](Steps& steps, const KnownCase& one, double t) {
                     change(steps.computed_from, t);
                     steps.has_right_impulse = false;
                     return one.approach == oracles::ContactState::colliding &&
                            (!is_of_cone || steps.law == Law::rough || steps.law == Law::coulomb);
                   },
                   false});
    return all.back();
  };
  const auto of_restitution = [&](const char* as_if, void (*change)(Collision&, double), double nothing) {
    Fit& fit = of(as_if, restitution, false, change);
    fit.starts = coefficients;
    fit.nothing = nothing;
  };
  of_restitution(
      "{} were added to ε", [](Collision& c, double t) { c.restitution += t; }, 0);
  of_restitution(
      "ε were multiplied by {}", [](Collision& c, double t) { c.restitution *= t; }, 1);
  of_restitution(
      "ε were always {}", [](Collision& c, double t) { c.restitution = t; }, 0);
  of("μ were multiplied by {}", friction, true, [](Collision& c, double t) { c.friction *= t; }).shown =
      [](const KnownCase& one) { return std::vector{shown_friction(one) / one.collision.friction}; };
  of("μ were always {}", friction, true, [](Collision& c, double t) { c.friction = t; }).shown =
      [](const KnownCase& one) { return std::vector{shown_friction(one)}; };
  of("the tangential restitution e_t were multiplied by {}", "the source of the tangential restitution", true,
     [](Collision& c, double t) { c.tangential_restitution *= t; });
}

/// Factors of the slip, and of what stops it.
void add_slips(std::vector<Fit>& all) {
  const auto of = [&](const char* as_if, const char* look_at, void (*change)(FrictionSteps&, double)) {
    all.push_back({as_if, look_at,
                   [change](Steps& steps, const KnownCase& one, double t) {
                     return with_friction([&](FrictionSteps& friction) { change(friction, t); })(steps, one);
                   },
                   false});
  };
  const char* const stop =
      "the impulse that stops the slip: for a solid sphere 2/7 m ‖V_T‖; its factors, and what resists";
  of("friction stopped {} of the slip that it should", stop,
     [](FrictionSteps& steps, double t) { steps.stopped *= t; });
  of("friction stopped {} of the slip, whatever its limit", stop, [](FrictionSteps& steps, double t) {
    steps.stopped *= t;
    steps.limit = FrictionLimit::none;
  });
  of("friction stopped {} of the slip of bodies that cannot turn",
     "the impulse that stops the slip: V_T over 1/m and r × J⁻¹ (r × t), for a solid sphere 2/7 m",
     [](FrictionSteps& steps, double t) {
       steps.stopped *= t;
       steps.response = FrictionResponse::without_turning;
       steps.order = steps.order == FrictionOrder::together ? FrictionOrder::of_slip_before : steps.order;
     });
  const char* const spin = "the spin in the slip V_T: v + w × r of each body";
  of("the spin of A in the slip were multiplied by {}", spin,
     [](FrictionSteps& steps, double t) { steps.spin_of_a *= t; });
  of("the spin of B in the slip were multiplied by {}", spin,
     [](FrictionSteps& steps, double t) { steps.spin_of_b *= t; });
}

void add_tangential_part(std::vector<Fit>& all) {
  all.push_back(factor_of(
      "the tangential part of the impulse were multiplied by {}",
      "the tangential part of the impulse: its factors and its sign",
      [](Steps& steps, double t) { steps.tangential *= t; }, false));
}

double longest_arm(const KnownCase& one) {
  return std::max((one.collision.point - one.collision.a.position).stableNorm(),
                  (one.collision.point - one.collision.b.position).stableNorm());
}

/// Numbers that are added: to the contact point, and to K.
void add_additions(std::vector<Fit>& all) {
  const auto of = [&](const char* as_if, const char* look_at, auto change, double (*unit)(const KnownCase&)) {
    all.push_back({as_if, look_at, change, true, false, 0, additions, unit});
  };
  const auto moved = [&](const char* as_if, auto direction) {
    of(
        as_if, "the source of the contact point: the surface of which body, the middle of an overlap, margins",
        [direction](Steps& steps, const KnownCase& one, double t) {
          return misread_as([&](Collision& c) { c.point += t * direction(c); })(steps, one);
        },
        longest_arm);
  };
  moved("the contact point were moved by {} m along the normal",
        [](const Collision& c) -> Vector3<double> { return c.normal.stableNormalized(); });
  moved("the contact point were moved by {} m along x", [](const Collision&) { return Vector3<double>::UnitX(); });
  moved("the contact point were moved by {} m along y", [](const Collision&) { return Vector3<double>::UnitY(); });
  moved("the contact point were moved by {} m along z", [](const Collision&) { return Vector3<double>::UnitZ(); });
  of(
      "{} 1/kg were added to the diagonal of the collision matrix K",
      "the collision matrix: softness, regularisation, a constraint force mixing",
      [](Steps& steps, const KnownCase&, double t) {
        steps.matrix.added += t;
        steps.has_right_impulse = false;
        return true;
      },
      [](const KnownCase& one) { return oracles::inverse_mass(one.collision); });
  all.back().changes_application = false;
}

std::vector<double> lengths_of(const KnownCase& one, OutcomeVector x, OutcomeVector y) {
  return {vectors(one.answered)[x]->stableNorm(), vectors(one.answered)[y]->stableNorm()};
}

void limit_ratio(Collision& c, double most) {
  if (!c.a.immovable && !c.b.immovable) {
    c.a.mass = std::min(c.a.mass, most * c.b.mass);
    c.b.mass = std::min(c.b.mass, most * c.a.mass);
  }
}

void add_limits(std::vector<Fit>& all) {
  using enum OutcomeVector;
  struct Limit {
    Use use;
    void (*apply)(Collision&, double);
  };
  const auto of = [&](const std::string& as_if, const char* look_at, Limit change) -> Fit& {
    all.push_back({as_if, look_at,
                   [change](Steps& steps, const KnownCase& one, double t) {
                     return t > 0 && misread_in(change.use, [&](Collision& c) { change.apply(c, t); })(steps, one);
                   },
                   change.use == Use::everywhere, true, unlimited});
    return all.back();
  };
  const auto shown = [&](const char* as_if, const char* look_at, double Steps::*limit, bool applied,
                         std::vector<double> (*lengths)(const KnownCase&)) {
    all.push_back({as_if,
                   look_at,
                   [limit](Steps& steps, const KnownCase&, double t) {
                     steps.*limit = t;
                     return true;
                   },
                   applied,
                   true,
                   unlimited,
                   {},
                   nullptr,
                   lengths});
  };
  shown("impulses were limited to {} N s", "limits on the impulse", &Steps::most_impulse, false,
        [](const KnownCase& one) {
          const Collision& c = one.collision;
          return std::vector{oracles::impulse_on_a(c, one.answered, oracles::reads_impulse_off_a(c)).stableNorm()};
        });
  shown("speeds after the impulse were limited to {} m/s", "limits on the velocities", &Steps::most_speed, true,
        [](const KnownCase& one) { return lengths_of(one, velocity_of_a, velocity_of_b); });
  shown("spins after the impulse were limited to {} rad/s", "limits on the angular velocity", &Steps::most_spin, true,
        [](const KnownCase& one) { return lengths_of(one, angular_velocity_of_a, angular_velocity_of_b); });
  for (const Use use : {Use::everywhere, Use::computation}) {
    Fit& ratio = of(std::string("the larger mass were at most {} times the smaller one") + words_of(use),
                    "limits on the ratio of the masses", Limit{use, limit_ratio});
    ratio.starts = most_values;
    ratio.unit = [](const KnownCase& one) {
      const double a_over_b = one.collision.a.mass / one.collision.b.mass;
      return std::max(a_over_b, 1 / a_over_b);
    };
    Fit& moments =
        of(std::string("the moments were at least {} kg m²") + words_of(use), "limits on the moments of inertia",
           Limit{use, [](Collision& c, double least) {
                   c.a.principal_inertia = c.a.principal_inertia.cwiseMax(least);
                   c.b.principal_inertia = c.b.principal_inertia.cwiseMax(least);
                 }});
    moments.starts = least_values;
    moments.unit = [](const KnownCase& one) {
      const Collision& c = one.collision;
      return std::min(c.a.immovable ? unlimited : c.a.principal_inertia.minCoeff(),
                      c.b.immovable ? unlimited : c.b.principal_inertia.minCoeff());
    };
  }
}

/// The quotient of small integers that equals the number, or its first digits, at most four.
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
  if (number != 1 && std::abs(number - 1) < readable) {
    return fmt::format("1 {} {:.2g}", number < 1 ? "−" : "+", std::abs(number - 1));
  }
  // Answers show a number to a share of 2⁻¹⁰ (`agree`), so -0.0009999 is as good as -0.001.
  double shortest = number;
  for (const char* const digits : {"{:.4g}", "{:.3g}", "{:.2g}", "{:.1g}"}) {
    const double shorter = std::stod(fmt::format(fmt::runtime(digits), number));
    shortest = std::abs(shorter - number) <= 0x1p-11 * std::abs(number) ? shorter : shortest;
  }
  return fmt::format("{:.4g}", shortest);
}

}  // namespace

std::span<const Fit> all_fits() {
  static const std::vector<Fit> all = [] {
    std::vector<Fit> fits;
    // Of two that explain alike, the first one is named. Factors of the bodies also change the normal part. So if
    // they explain no more than factors of the slip, friction is the cause.
    for (const auto add : {add_factors_of_impulse, add_slips, add_factors_of_bodies, add_coefficients,
                           add_tangential_part, add_additions, add_limits}) {
      add(fits);
    }
    return fits;
  }();
  return all;
}

bool agree(double x, double y) {
  constexpr double alike = 0x1p-10;
  return std::abs(x - y) <= alike * std::max(std::abs(x), std::abs(y));
}

std::vector<double> fitted(const Fit& fit, const Steps& steps, const KnownCase& one) {
  const auto outcome_at = [&](double number) -> std::optional<Outcome<double>> {
    Steps changed = steps;
    changed.effort = Effort::without_rationals;  // because a search takes dozens of answers
    return fit.change(changed, one, number) ? outcome_of(changed, one) : std::nullopt;
  };
  std::vector<double> numbers;
  if (!has_movable_body(one.collision)) {
    return numbers;
  }
  if (fit.shown != nullptr) {
    for (const double number : fit.shown(one)) {
      const auto outcome = std::isfinite(number) ? outcome_at(number) : std::nullopt;
      if (outcome && is_explained_by(*outcome, one)) {
        numbers.push_back(number);
      }
    }
    return numbers;
  }
  const double unit = fit.unit == nullptr ? 1 : fit.unit(one);
  const std::span<const double> starts = fit.starts.empty() ? std::span<const double>(first_factors) : fit.starts;
  constexpr double near = 1 + 0x1p-10;
  Number found;
  if (std::isfinite(fit.nothing)) {
    found = found_from(fit.nothing, fit.nothing + unit / 2, outcome_at, one);
  }
  for (std::size_t i = 0; i < starts.size() && !found && std::isfinite(unit); ++i) {
    found = found_from(unit * starts[i], near * unit * starts[i], outcome_at, one);
  }
  // If the other mistakes give the answer, the search finds the number that changes nothing, within rounding.
  constexpr double rounding = 0x1p-30;
  if (found && !(std::isfinite(fit.nothing) && std::abs(*found - fit.nothing) <= rounding * std::abs(unit))) {
    // A factor near 0 leaves only rounding of its part, so the search ends at any such number.
    constexpr double negligible = 0x1p-20;
    const bool is_factor = fit.nothing == 1 && fit.unit == nullptr && !fit.is_limit;
    numbers.push_back(is_factor && std::abs(*found) <= negligible ? 0 : *found);
  }
  return numbers;
}

Hypothesis with_number(const Fit& fit, double number) {
  return {fmt::format(fmt::runtime(fit.as_if), in_words(number)),
          fit.look_at,
          {[change = fit.change, number](Steps& steps, const KnownCase& one) { return change(steps, one, number); }},
          fit.changes_application,
          true,
          fit.is_limit};
}

}  // namespace carom::properties::diagnosis
