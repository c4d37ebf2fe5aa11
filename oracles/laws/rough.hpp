// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/expects.hpp>
#include <carom/oracles/laws/certify.hpp>

/// The definition of the law `rough` (A. Chatterjee, A. Ruina, J. Appl. Mech. 65, 1998; docs/guide/laws.md gives its
/// formulas).
namespace carom::oracles {

template <class T>
struct RoughParts {
  Outcome<T> approach_stopped;  // the answer of `frictionless` at ε = 0, from the impulse P_I
  Outcome<T> point_stopped;     // the answer of `sticking` at ε = 0, from the impulse P_II
  T friction_share;             // κ
};

/// The first condition of the definition of `rough` that an outcome y certainly violates; nullptr if there is none. The
/// velocities before the impulse are y⁻, and y has the impulse F. The part `approach_stopped` has the outcome y_I and
/// the impulse P_I, and `point_stopped` has y_II and P_II:
///
///   (1) y_I is the answer of `frictionless` at ε = 0, and y_II the answer of `sticking` at ε = 0;
///   (2) y − y⁻ = (1 + ε) (y_I − y⁻) + κ (y_II − y_I), so that F = (1 + ε) P_I + κ (P_II − P_I);
///   (3) F lies in the cone: N·F ≥ 0 and ‖N × F‖ ≤ μ N·F;
///   (4) κ = 1 + e_t, or 0 ≤ κ ≤ 1 + e_t with F on the cone's surface.
///
/// T is as in `certainly_differ`, and `c` is the collision in T. Preconditions: the law answers as if the contact
/// collides; a body is movable; e_t ≥ −1.
template <class T>
[[nodiscard]] const char* first_refuted_of_rough(const Collision& collision, const BasicCollision<T>& c,
                                                 const Outcome<T>& outcome, const RoughParts<T>& parts) {
  CAROM_EXPECTS(has_movable_body(collision));
  BasicCollision<T> inelastic = c;
  inelastic.restitution = T(0);
  const auto refuted_part = [&](Law law, const Outcome<T>& part) {
    return first_refuted(collision, inelastic, law, ContactState::colliding, part);
  };
  if (const char* const refuted = refuted_part(Law::frictionless, parts.approach_stopped)) {
    return refuted;
  }
  if (const char* const refuted = refuted_part(Law::sticking, parts.point_stopped)) {
    return refuted;
  }
  const Outcome<T> before = unchanged(c);
  const auto y = vectors(outcome);
  const auto y_before = vectors(before);
  const auto y_approach = vectors(parts.approach_stopped);
  const auto y_point = vectors(parts.point_stopped);
  const T& share = parts.friction_share;
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      const T& at_first = (*y_before[k])[i];
      const T& stopped = (*y_approach[k])[i];
      if (certainly_differ<T>((*y[k])[i] - at_first,
                              (T(1) + c.restitution) * (stopped - at_first) + share * ((*y_point[k])[i] - stopped))) {
        return "the combination of its parts";
      }
    }
  }
  const Vector3<T> impulse = impulse_on_a(c, outcome, reads_impulse_off_a(collision));
  const Sides<T, 1> cone = squared_cone(c, impulse);
  if (is_certainly_less<T>(c.normal.dot(impulse), T(0)) || is_certainly_less<T>(cone.right[0], cone.left[0])) {
    return "the friction cone";
  }
  const T whole = T(1) + c.tangential_restitution;
  const bool is_between = !is_certainly_less<T>(share, T(0)) && !is_certainly_less<T>(whole, share);
  return is_between && !(certainly_differ<T>(share, whole) && certainly_differ<T>(cone.left[0], cone.right[0]))
             ? nullptr
             : "its share of friction";
}

/// Checks exactly that an outcome satisfies the definition of `rough`. Throws a JudgeError that names the condition
/// that fails. T is an exact field. Preconditions: those of `first_refuted_of_rough`.
template <class T>
void certify_rough(const BasicCollision<T>& c, const Outcome<T>& outcome, const RoughParts<T>& parts) {
  const Collision collision = map_numbers<double>(c, [](const T& x) { return nearest_double(x); });
  throw_if_refuted(first_refuted_of_rough(collision, c, outcome, parts), "the truth of `rough`", collision);
}

}  // namespace carom::oracles
