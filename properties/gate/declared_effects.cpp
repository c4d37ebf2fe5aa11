// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/oracles/bounds/certain_sign.hpp>
#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/exact/radical.hpp>
#include <carom/oracles/laws/mechanics.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/gate/declared_effects.hpp>

namespace carom::properties {
namespace {

using oracles::Rational;

/// Whether the contact approaches more slowly than this: 0 < −N·V⁻ < speed ‖N‖. No value if bounds do not decide it.
template <class T>
std::optional<bool> is_slower_than(const BasicCollision<T>& collision, double speed) {
  const T normal_velocity = oracles::normal_velocity_before(collision);
  const std::optional<int> direction = oracles::certain_sign(normal_velocity);
  if (direction.value_or(-1) >= 0) {
    return false;
  }
  const T limit = T(speed) * T(speed) * collision.normal.dot(collision.normal);
  const std::optional<int> excess = oracles::certain_sign(T(normal_velocity * normal_velocity - limit));
  if (excess.value_or(-1) >= 0) {
    return false;
  }
  return direction && excess ? std::optional(true) : std::nullopt;
}

bool is_slower_than(const Collision& posed, double speed) {
  if (speed == 0) {
    return false;
  }
  const auto enclosed =
      map_numbers<oracles::Enclosure>(posed, [](double number) { return oracles::Enclosure(number); });
  const std::optional<bool> by_bounds = is_slower_than(enclosed, speed);
  return by_bounds ? *by_bounds : *is_slower_than(oracles::lift(posed), speed);
}

bool is_near_speed(const oracles::ExactCase& posed, double speed, double allowance) {
  const double limit = speed * oracles::norm_of(posed.collision().normal);
  const double approach = -oracles::normal_velocity_before(posed.collision());
  return std::abs(approach - limit) <= allowance * (posed.normal_velocity_sensitivity() + limit);
}

/// The number, rounded to a rational with a relative error of at most 2⁻¹⁵⁰.
Rational rounded(const Rational& number) { return number; }
Rational rounded(const oracles::Radical& number) { return approximately(number); }

/// Damping keeps this share of a velocity.
Rational kept_by(double damping) { return Rational(1) - Rational(damping); }

/// A limit shortens a vector of the law's answer by this factor, after damping has kept the share `kept`. The factor is
/// 1 if the vector is not longer than the limit, or if there is no limit.
template <class T>
Rational shortening(const Vector3<T>& of_law, const Rational& kept, double limit) {
  if (limit == 0) {
    return Rational(1);
  }
  const Vector3<Rational> damped = of_law.unaryExpr([](const T& x) { return rounded(x); }) * kept;
  const Rational squared = damped.squaredNorm() / (Rational(limit) * Rational(limit));
  return squared > 1 ? Rational(1) / approximately(oracles::Radical::root_of(squared)) : Rational(1);
}

bool limits_speeds(const DeclaredEffects& effects) {
  return effects[DeclaredEffect::max_speed] > 0 || effects[DeclaredEffect::max_angular_velocity] > 0;
}

bool damps(const DeclaredEffects& effects) {
  return effects[DeclaredEffect::linear_damping] > 0 || effects[DeclaredEffect::angular_damping] > 0;
}

/// Whether bounds show that the law's velocities stay below every limit.
bool is_surely_below_limits(const DeclaredEffects& effects, const BodyVelocity<oracles::Enclosure>& of_law) {
  const auto is_below = [](const Vector3<oracles::Enclosure>& vector, double limit) {
    double sum = 0;
    for (const oracles::Enclosure& x : vector) {
      sum += x.magnitude_above();
    }
    return limit == 0 || sum < limit;  // the length is at most the sum of the components
  };
  return is_below(of_law.velocity, effects[DeclaredEffect::max_speed]) &&
         is_below(of_law.angular_velocity, effects[DeclaredEffect::max_angular_velocity]);
}

/// The limits that a velocity is as long as, within a relative difference.
EffectFlags limits_reached(const DeclaredEffects& effects, const BodyVelocity<double>& answered, double difference) {
  EffectFlags reached;
  const auto look_at = [&](DeclaredEffect limit, const Vector3<double>& vector) {
    reached[limit] = effects[limit] > 0 && oracles::norm_of(vector) >= effects[limit] * (1 - difference);
  };
  look_at(DeclaredEffect::max_speed, answered.velocity);
  look_at(DeclaredEffect::max_angular_velocity, answered.angular_velocity);
  return reached;
}

EffectFlags either(EffectFlags flags, const EffectFlags& others) {
  for (const DeclaredEffect effect : all_declared_effects) {
    flags[effect] = flags[effect] || others[effect];
  }
  return flags;
}

/// Takes the effects out of the velocities of one body. `of_law` is the law's answer. Returns the limits that the law's
/// answer is beyond.
template <class T>
EffectFlags take_out_of_body(BodyVelocity<Rational>& answered, const BodyVelocity<T>& of_law,
                             const DeclaredEffects& effects) {
  const Rational linear = kept_by(effects[DeclaredEffect::linear_damping]);
  const Rational angular = kept_by(effects[DeclaredEffect::angular_damping]);
  const Rational of_velocity = shortening(of_law.velocity, linear, effects[DeclaredEffect::max_speed]);
  const Rational of_spin = shortening(of_law.angular_velocity, angular, effects[DeclaredEffect::max_angular_velocity]);
  answered.velocity /= Rational(linear * of_velocity);
  answered.angular_velocity /= Rational(angular * of_spin);
  EffectFlags beyond;
  beyond[DeclaredEffect::max_speed] = of_velocity < 1;
  beyond[DeclaredEffect::max_angular_velocity] = of_spin < 1;
  return beyond;
}

}  // namespace

bool is_any(const EffectFlags& flags) { return std::ranges::any_of(flags, std::identity()); }

std::string to_text(const DeclaredEffects& effects) {
  std::string text;
  for (const DeclaredEffect effect : all_declared_effects) {
    if (effects[effect] != 0) {
      const std::string_view unit = unit_of(effect);
      text += fmt::format("{}{} {}{}{}", text.empty() ? "" : ", ", name_of(effect), effects[effect],
                          unit.empty() ? "" : " ", unit);
    }
  }
  return text;
}

DeclaredEffects with_named_effects(DeclaredEffects effects, const std::map<std::string, double>& named) {
  for (const auto& [name, size] : named) {
    const std::optional<DeclaredEffect> effect = declared_effect_named(name);
    if (!effect) {
      std::vector<std::string> known;
      for (const DeclaredEffect one : all_declared_effects) {
        known.emplace_back(name_of(one));
      }
      throw std::invalid_argument(fmt::format("there is no effect {}; expected one of {}{}", name,
                                              fmt::join(known, ", "), did_you_mean(name, known)));
    }
    effects[*effect] = size;
  }
  return effects;
}

void require_valid(const DeclaredEffects& effects, Law law) {
  for (const DeclaredEffect effect : all_declared_effects) {
    if (effects[effect] != 0 && !is_valid_size(effect, effects[effect])) {
      throw std::invalid_argument(fmt::format("{}: expected a positive number{}, found {}", name_of(effect),
                                              unit_of(effect).empty() ? " below 1" : "", effects[effect]));
    }
  }
  if (limits_speeds(effects) && !determines_outcome(law)) {
    throw std::invalid_argument(
        fmt::format("a limit of speeds needs a law that determines the outcome; {} does not", name_of(law)));
  }
}

bool depend_on_approach(const DeclaredEffects& effects) {
  return effects[DeclaredEffect::restitution_threshold] > 0 || effects[DeclaredEffect::slop] > 0;
}

Collision judged_collision(const Collision& posed, const DeclaredEffects& effects) {
  Collision judged = posed;
  if (!depend_on_approach(effects) || (posed.a.immovable && posed.b.immovable)) {
    return judged;
  }
  if (is_slower_than(posed, effects[DeclaredEffect::slop])) {
    judged.normal = -posed.normal;
  } else if (is_slower_than(posed, effects[DeclaredEffect::restitution_threshold])) {
    judged.restitution = 0;
  }
  return judged;
}

EffectFlags changes_between(const Collision& posed, const Collision& judged) {
  EffectFlags changes;
  changes[DeclaredEffect::slop] = judged.normal != posed.normal;
  changes[DeclaredEffect::restitution_threshold] = judged.restitution != posed.restitution;
  return changes;
}

EffectFlags at_declared_limit(const oracles::ExactCase& posed, const DeclaredEffects& effects, double allowance) {
  const auto is_near = [&](DeclaredEffect effect) {
    return effects[effect] > 0 && is_near_speed(posed, effects[effect], allowance);
  };
  EffectFlags near;
  near[DeclaredEffect::slop] = is_near(DeclaredEffect::slop);
  near[DeclaredEffect::restitution_threshold] =
      posed.collision().restitution > 0 && is_near(DeclaredEffect::restitution_threshold);
  return near;
}

EffectFlags take_out_effects(ExactAnswer& answer, const DeclaredEffects& effects, const oracles::ExactCase& judged,
                             Law law, double allowance) {
  auto* const outcome = std::get_if<oracles::LiftedOutcome>(&answer);
  if (outcome == nullptr || !(damps(effects) || limits_speeds(effects))) {
    return {};
  }
  Outcome<Rational> velocities = outcome->exact();
  EffectFlags shortened;
  EffectFlags reached;
  const auto take_out_of = [&](const Body& body, const auto& part) {
    if (body.immovable) {
      return;
    }
    reached = either(reached, limits_reached(effects, part(outcome->rounded()), allowance));
    if (!limits_speeds(effects) || is_surely_below_limits(effects, part(judged.enclosed_truth(law).outcome))) {
      take_out_of_body(part(velocities), BodyVelocity<Rational>{}, effects);
      return;
    }
    judged.with_truth(law, judged.state(), [&](const auto& truth) {
      shortened = either(shortened, take_out_of_body(part(velocities), part(truth.outcome), effects));
    });
  };
  take_out_of(
      judged.collision().a, [](auto& of_both) -> auto& { return of_both.a; });
  take_out_of(
      judged.collision().b, [](auto& of_both) -> auto& { return of_both.b; });
  if (is_any(shortened) || damps(effects)) {
    oracles::LiftedOutcome changed = std::move(*outcome).with_velocities(velocities);
    *outcome = std::move(changed);
  }
  return either(shortened, reached);
}

}  // namespace carom::properties
