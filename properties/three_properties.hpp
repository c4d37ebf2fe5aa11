// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/collision/precision.hpp>
#include <carom/collision/solved_outcome.hpp>

/// Read this first. It declares the properties of every collision response, under every law.
///
/// Two bodies A and B touch at a point P. The normal N points from B to A. V⁻ and V⁺ are the relative velocities of the
/// two contact points before and after the impulse F, and C is the collision matrix: C F = V⁺ − V⁻.
///
/// A solver is any callable from a collision to the velocities after the impulse: const Collision& → Outcome<S>. S is
/// float, double or long double. A solver that shows its collision matrix returns SolvedOutcome<S>. Each property below
/// is a function of a solver and a valid collision. Exact arithmetic checks the answer by the invariants in
/// `Property::invariants`. The property must hold exactly for some inputs and outputs within 32 units in the last place
/// of the solver's precision.
///
///     RC_GTEST_PROP(MySolver, NeverPenetrates, (const carom::Collision& collision)) {
///       RC_ASSERT(carom::properties::non_penetrating_post_velocity(my_solver, collision));
///     }
namespace carom::properties {

/// One of the three properties.
struct Property {
  std::string_view name;       // a key in lower case, with underscores
  std::string_view title;      // in words
  std::string_view statement;  // one sentence
  /// The names, in `all_invariants()`, of the invariants that judge the property. The theorems of these invariants
  /// prove the property (`Proof`, invariants/proof.hpp).
  std::vector<std::string_view> invariants;
};

/// Non-penetrating post-velocity, positive definiteness of C, and conservation of momentum.
[[nodiscard]] std::span<const Property> three_properties();

/// The judge's decision on one answer.
struct Ruling {
  bool holds = true;
  bool is_in_domain = true;  // if false, the property does not apply to the collision, and `holds` is true
  std::string text = {};     // what is violated, or why the collision is not in the domain

  explicit operator bool() const { return holds; }
};

/// Prints a ruling for RapidCheck.
inline void showValue(const Ruling& ruling, std::ostream& out) { out << (ruling.holds ? "it holds" : ruling.text); }

namespace detail {

/// The ruling of the property of this name on the answer to a collision. Preconditions: `three_properties()` has this
/// name, and the collision is valid (`validate`).
[[nodiscard]] Ruling ruling(std::string_view property, const Collision& collision, const ReportedOutcome& answer,
                            Precision precision);

template <class S>
[[nodiscard]] Ruling ruling(std::string_view property, const Collision& collision, const Outcome<S>& answer,
                            std::optional<Precision> precision) {
  return ruling(property, collision, reported(answer), precision.value_or(precision_of<S>));
}
template <class S>
[[nodiscard]] Ruling ruling(std::string_view property, const Collision& collision, const SolvedOutcome<S>& answer,
                            std::optional<Precision> precision) {
  return ruling(property, collision, reported(answer), precision.value_or(precision_of<S>));
}

}  // namespace detail

// Pass `precision` if the solver computes in another precision than that of S.

/// After the impulse the bodies do not approach at the contact: N·V⁺ ≥ 0. The property applies to contacts with a
/// movable body.
template <class Solver>
[[nodiscard]] Ruling non_penetrating_post_velocity(Solver&& solver, const Collision& collision,
                                                   std::optional<Precision> precision = std::nullopt) {
  return detail::ruling("non_penetrating_post_velocity", collision, solver(collision), precision);
}

/// The collision matrix is symmetric and positive definite, with λI ⪯ C and λ = 1/m_A + 1/m_B > 0. It also fits the
/// answer: C F = V⁺ − V⁻. The property applies to contacts with a movable body for which the solver shows C [1/kg], in
/// world axes.
template <class Solver>
[[nodiscard]] Ruling positive_definiteness(Solver&& solver, const Collision& collision,
                                           std::optional<Precision> precision = std::nullopt) {
  const auto answer = solver(collision);
  static_assert(
      requires { answer.collision_matrix; }, "the solver must return SolvedOutcome, with its matrix");
  return detail::ruling("positive_definiteness", collision, answer, precision);
}

/// One body gains the linear momentum that the other loses: m_A Δv_A = −m_B Δv_B. Each body turns by the moment of its
/// impulse, J Δw = r × (m Δv), so the angular momentum about every point is kept as well. If one body is immovable,
/// only J Δw = r × (m Δv) of the other body applies.
template <class Solver>
[[nodiscard]] Ruling momentum_conservation(Solver&& solver, const Collision& collision,
                                           std::optional<Precision> precision = std::nullopt) {
  return detail::ruling("momentum_conservation", collision, solver(collision), precision);
}

}  // namespace carom::properties
