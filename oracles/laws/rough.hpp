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

/// Checks exactly that an outcome y satisfies the definition of `rough`. The velocities before the impulse are y⁻, and
/// y has the impulse F. The part `approach_stopped` has the outcome y_I and the impulse P_I, and `point_stopped` has
/// y_II and P_II:
///
///   (1) y_I is the answer of `frictionless` at ε = 0, and y_II the answer of `sticking` at ε = 0;
///   (2) y − y⁻ = (1 + ε) (y_I − y⁻) + κ (y_II − y_I), so that F = (1 + ε) P_I + κ (P_II − P_I);
///   (3) F lies in the cone: N·F ≥ 0 and ‖N × F‖ ≤ μ N·F;
///   (4) κ = 1 + e_t, or 0 ≤ κ ≤ 1 + e_t with F on the cone's surface.
///
/// T is an ordered exact field. Throws a JudgeError that names the condition that fails. Preconditions: the
/// contact collides; a body is movable; e_t ≥ −1.
template <class T>
void certify_rough(const BasicCollision<T>& collision, const Outcome<T>& outcome, const RoughParts<T>& parts) {
  CAROM_EXPECTS(has_movable_body(collision));
  const auto demand = [&](bool holds, const char* what) {
    if (!holds) {
      fail_to_certify(collision, "the truth of `rough`", what);
    }
  };
  BasicCollision<T> inelastic = collision;
  inelastic.restitution = T(0);
  const auto demand_part = [&](Law law, const Outcome<T>& part) {
    const char* const unsatisfied = first_unsatisfied(inelastic, law, ContactState::colliding, part);
    demand(unsatisfied == nullptr, unsatisfied);
  };
  demand_part(Law::frictionless, parts.approach_stopped);
  demand_part(Law::sticking, parts.point_stopped);
  const Outcome<T> before = unchanged(collision);
  const auto y = vectors(outcome);
  const auto y_before = vectors(before);
  const auto y_approach = vectors(parts.approach_stopped);
  const auto y_point = vectors(parts.point_stopped);
  const T& share = parts.friction_share;
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      const T& at_first = (*y_before[k])[i];
      const T& stopped = (*y_approach[k])[i];
      demand((*y[k])[i] - at_first ==
                 (T(1) + collision.restitution) * (stopped - at_first) + share * ((*y_point[k])[i] - stopped),
             "the combination of its parts");
    }
  }
  const Vector3<T> impulse = impulse_on_a(collision, outcome, reads_impulse_off_a(collision));
  const Sides<T, 1> cone = squared_cone(collision, impulse);
  demand(!(collision.normal.dot(impulse) < T(0)) && !(cone.left[0] > cone.right[0]), "the friction cone");
  const T whole = T(1) + collision.tangential_restitution;
  demand(!(share < T(0)) && !(share > whole) && (share == whole || cone.left[0] == cone.right[0]),
         "its share of friction");
}

}  // namespace carom::oracles
