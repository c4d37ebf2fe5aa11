// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>

#include <carom/collision/expects.hpp>
#include <carom/impulse/contact.hpp>
#include <carom/impulse/normal_velocity.hpp>
#include <carom/impulse/rough.hpp>

/// Outcomes that never penetrate: N·V⁺ ≥ 0, exactly, for N, P, X as they stand in the collision and the velocities that
/// are returned. A law computed with rounding gives N·V⁺ < 0 in about half of all cases where ε = 0. Needs the
/// collision itself, since the lever arms of a Contact are rounded.
namespace carom::impulse {

namespace detail {

[[nodiscard]] inline bool all_finite(const Outcome<double>& outcome) {
  for (const Vector3<double>* vector : vectors(outcome)) {
    if (!std::isfinite((*vector)[0]) || !std::isfinite((*vector)[1]) || !std::isfinite((*vector)[2])) {
      return false;
    }
  }
  return true;
}

/// What a component of r × N = (P − X) × N may be off by, relatively to |r_j N_k| + |r_k N_j|: each product has two
/// roundings, their difference one, and one is left for the roundings of that sum.
inline constexpr double rounding_of_slope = 4 * unit_roundoff_of_double;

/// A velocity component, and how fast N·V grows with it.
struct Adjustable {
  double* component = nullptr;
  double slope = 0;
  double ulp = 0;
};

/// Which of two bodies is moved where both would do: the lighter one, else the slower one, component by component. It
/// depends neither on which of them is called A nor on the signs that a mirror changes.
[[nodiscard]] inline bool comes_before(const Body& x, const Body& y) {
  const auto key = [](const Body& body) {
    const auto size = [](const Vector3<double>& v) {
      return std::array{std::abs(v[0]), std::abs(v[1]), std::abs(v[2])};
    };
    return std::tuple{body.mass, size(body.velocity), size(body.angular_velocity)};
  };
  return key(x) < key(y);
}

/// The component of the movable bodies an ulp of which moves N·V furthest, so that the fewest ulps are needed.
[[nodiscard]] inline Adjustable most_effective_component(const Collision& c, Outcome<double>& outcome) {
  Adjustable best;
  double most = -1;
  const auto consider = [&](double& component, double slope) {
    const double size = std::abs(component);
    const double ulp = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
    const double effect = std::abs(slope) * ulp;
    if (slope != 0 && effect > most) {
      most = effect;
      best = {&component, slope, ulp};
    }
  };
  const auto consider_body = [&](const Body& body, BodyVelocity<double>& motion, double s) {
    if (body.immovable) {
      return;
    }
    const Vector3<double> r = c.point - body.position;
    for (int i = 0; i < 3; ++i) {
      consider(motion.velocity[i], s * c.normal[i]);
    }
    for (int i = 0; i < 3; ++i) {
      const auto [left, right] = moment_terms<double>(r, c.normal, i);
      // Where r × N may be rounding alone, its sign is not known.
      const double slope = left - right;
      const bool sign_is_known = std::abs(slope) > rounding_of_slope * (std::abs(left) + std::abs(right));
      consider(motion.angular_velocity[i], sign_is_known && std::isfinite(slope) ? s * slope : 0);
    }
  };
  const bool b_first = comes_before(c.b, c.a);
  if (b_first) {
    consider_body(c.b, outcome.b, -1);
  }
  consider_body(c.a, outcome.a, 1);
  if (!b_first) {
    consider_body(c.b, outcome.b, -1);
  }
  return best;
}

}  // namespace detail

/// The outcome with as few ulps added to one component of a movable body at a time as make N·V⁺ ≥ 0; untouched where it
/// is so already, where no body can move, and where a number is not finite. Precondition: the collision is valid.
[[nodiscard]] inline Outcome<double> without_approach(const Collision& collision, Outcome<double> outcome) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  if (collision.a.immovable && collision.b.immovable) {
    return outcome;
  }
  double ulps = 1;
  while (detail::all_finite(outcome)) {
    const detail::RoundedNormalVelocity<double> roughly(collision, outcome, detail::unit_roundoff_of_double);
    if (roughly.value > roughly.bound) {
      break;
    }
    const NormalVelocity velocity = known_normal_velocity(collision, outcome);
    if (velocity.sign >= 0) {
      break;
    }
    const auto [component, slope, ulp] = detail::most_effective_component(collision, outcome);
    // At least one ulp, so that N·V grows each time; more where the law itself was evaluated badly. Where N·V
    // underflows nothing tells how far it is from zero, which may be more ulps than anyone can wait for: twice as many
    // each time.
    *component += std::copysign(std::fmax(-velocity.value / std::abs(slope), ulps * ulp), slope);
    ulps = velocity.value == 0 ? 2 * ulps : 1;
  }
  return outcome;
}

namespace detail {

/// The contact with these velocities, and without restitution.
[[nodiscard]] inline Contact<double> at_velocities(Contact<double> contact, const Outcome<double>& motion) {
  contact.a.velocity = motion.a.velocity;
  contact.a.angular_velocity = motion.a.angular_velocity;
  contact.b.velocity = motion.b.velocity;
  contact.b.angular_velocity = motion.b.angular_velocity;
  contact.restitution = 0;
  return contact;
}

/// The contact once more, by the law; by the frictionless one where the law has done with friction.
template <class Law>
[[nodiscard]] Outcome<double> struck_again(const Contact<double>& contact, const Law& law, double approach) {
  if constexpr (std::is_same_v<std::invoke_result_t<const Law&, const Contact<double>&>, RoughImpulse<double>>) {
    return apply_impulse(contact, frictionless_impulse(contact, approach));
  } else {
    return apply_impulse(contact, law(contact, approach));
  }
}

/// Whether a few ulps of one component take the N·V⁺ < 0 that is left. An impulse that takes it may move a slender
/// body's spin by many: what the rounding of a spin leaves is more than what its slight part about the long axis is.
[[nodiscard]] inline bool is_within_few_ulps(const Collision& collision, Outcome<double> outcome, double left) {
  constexpr double few = 4;
  const auto [component, slope, ulp] = most_effective_component(collision, outcome);
  return -left <= few * ulp * std::abs(slope);
}

}  // namespace detail

/// `law` (Contact<double>, N·V⁻ → what apply_impulse takes) without penetration: where the exact N·V⁻ is not negative
/// the velocities are kept, elsewhere the law's outcome is rounded so that the exact N·V⁺ is not negative.
/// Precondition: the collision is valid, and the contact was made from it.
template <class Law>
[[nodiscard]] Outcome<double> guaranteed(const Collision& collision, const Contact<double>& contact, const Law& law) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  const Outcome<double> before = unchanged(collision);
  if (normal_velocity_sign(collision, before) >= 0) {
    return before;
  }
  // A length of the contact's normal in units of the collision's.
  const double unit = contact.normal.cwiseAbs().maxCoeff() / collision.normal.cwiseAbs().maxCoeff();
  // N·V as it is, and not as rounded, so that there is little to mend.
  const auto known_approach = [&](const Outcome<double>& motion) {
    return known_normal_velocity(collision, motion).value * unit;
  };
  const auto is_usable = [](double approach) { return std::isfinite(approach) && approach < 0; };
  const double approach = known_approach(before);
  Outcome<double> outcome = apply_impulse(contact, is_usable(approach) ? law(contact, approach) : law(contact));
  // What the rounding of a great impulse left of the approach is taken by another one, which keeps the momenta.
  if (const double left = detail::all_finite(outcome) ? known_approach(outcome) : 0;
      is_usable(left) && !detail::is_within_few_ulps(collision, outcome, left / unit)) {
    const Contact<double> again = detail::at_velocities(contact, outcome);
    outcome = detail::struck_again(again, law, left);
  }
  return without_approach(collision, outcome);
}

}  // namespace carom::impulse
