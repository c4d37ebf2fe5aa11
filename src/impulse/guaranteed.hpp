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

/// Outcomes that never penetrate: N·V⁺ ≥ 0 exactly, for the returned velocities and the stored numbers of the
/// collision. (A law computed with rounding gives N·V⁺ < 0 in about half of all cases with ε = 0.)
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

/// A bound of the error of a component of r × N, relative to |r_j N_k| + |r_k N_j|. It covers four roundings: of r, of
/// the products, of their difference, and of the sum of absolute values.
inline constexpr double rounding_of_slope = 4 * unit_roundoff_of_double;

/// A velocity component, the derivative `slope` of N·V by this component, and the ulp of the component.
struct Adjustable {
  double* component = nullptr;
  double slope = 0;
  double ulp = 0;
};

/// Whether to adjust x rather than y if one ulp of either changes N·V equally. The lighter body comes first; if the
/// masses are equal, the body with smaller velocity components. Exchanging A and B, or mirroring, does not change the
/// choice.
[[nodiscard]] inline bool comes_before(const Body& x, const Body& y) {
  const auto key = [](const Body& body) {
    const auto size = [](const Vector3<double>& v) {
      return std::array{std::abs(v[0]), std::abs(v[1]), std::abs(v[2])};
    };
    return std::tuple{body.mass, size(body.velocity), size(body.angular_velocity)};
  };
  return key(x) < key(y);
}

/// The component, among the velocities of movable bodies, whose ulp changes N·V most.
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

/// The outcome, corrected until N·V⁺ ≥ 0. Each step adds as few ulps as necessary to one velocity component of a
/// movable body. The outcome is unchanged if N·V⁺ ≥ 0 already, if no body can move, or if a number is not finite.
/// Precondition: the collision is valid.
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
    // Each step is at least one ulp, so that N·V grows. If N·V underflows to 0, its size is unknown, so the step
    // doubles each time.
    *component += std::copysign(std::fmax(-velocity.value / std::abs(slope), ulps * ulp), slope);
    ulps = velocity.value == 0 ? 2 * ulps : 1;
  }
  return outcome;
}

namespace detail {

[[nodiscard]] inline Contact<double> at_velocities(Contact<double> contact, const Outcome<double>& motion) {
  contact.a.velocity = motion.a.velocity;
  contact.a.angular_velocity = motion.a.angular_velocity;
  contact.b.velocity = motion.b.velocity;
  contact.b.angular_velocity = motion.b.angular_velocity;
  contact.restitution = 0;
  return contact;
}

/// The outcome of a second impulse by the solver. After `rough`, this impulse is frictionless, because friction has
/// already acted.
template <class Solver>
[[nodiscard]] Outcome<double> struck_again(const Contact<double>& contact, const Solver& solver, double approach) {
  if constexpr (std::is_same_v<std::invoke_result_t<const Solver&, const Contact<double>&>, RoughImpulse<double>>) {
    return apply_impulse(contact, frictionless_impulse(contact, approach));
  } else {
    return apply_impulse(contact, solver(contact, approach));
  }
}

/// Whether a few ulps of one velocity component cancel `left`, the N·V⁺ < 0 that remains. If so, a second impulse would
/// be worse: its rounding error may exceed the small spin of a slender body about its long axis.
[[nodiscard]] inline bool is_within_few_ulps(const Collision& collision, Outcome<double> outcome, double left) {
  constexpr double few = 4;
  const auto [component, slope, ulp] = most_effective_component(collision, outcome);
  return -left <= few * ulp * std::abs(slope);
}

}  // namespace detail

/// The outcome of `solver`, corrected so that the bodies do not penetrate. The solver maps a Contact<double>, and N·V⁻
/// if it is given, to an impulse for apply_impulse. If the exact N·V⁻ is not negative, the velocities are unchanged.
/// Otherwise the exact N·V⁺ is not negative. Precondition: the collision is valid, and the contact was made from it.
template <class Solver>
[[nodiscard]] Outcome<double> guaranteed(const Collision& collision, const Contact<double>& contact,
                                         const Solver& solver) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  const Outcome<double> before = unchanged(collision);
  if (normal_velocity_sign(collision, before) >= 0) {
    return before;
  }
  // The length of the contact's normal, divided by the length of the collision's normal.
  const double unit = contact.normal.cwiseAbs().maxCoeff() / collision.normal.cwiseAbs().maxCoeff();
  const auto known_approach = [&](const Outcome<double>& motion) {
    return known_normal_velocity(collision, motion).value * unit;
  };
  const auto is_usable = [](double approach) { return std::isfinite(approach) && approach < 0; };
  const double approach = known_approach(before);
  Outcome<double> outcome = apply_impulse(contact, is_usable(approach) ? solver(contact, approach) : solver(contact));
  // The rounding error of a large impulse may leave a part of the approach. A second impulse removes this part, and
  // conserves the momenta.
  if (const double left = detail::all_finite(outcome) ? known_approach(outcome) : 0;
      is_usable(left) && !detail::is_within_few_ulps(collision, outcome, left / unit)) {
    const Contact<double> again = detail::at_velocities(contact, outcome);
    outcome = detail::struck_again(again, solver, left);
  }
  return without_approach(collision, outcome);
}

}  // namespace carom::impulse
