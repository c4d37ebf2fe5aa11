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

/// Read this header first. It declares three properties that every collision response has, under every law.
///
/// Two bodies A and B touch at a point P. The normal N points from B to A. V⁻ and V⁺ are the velocities of A's contact
/// point relative to B's, before and after the impulse F on A. C is the collision matrix: C F = V⁺ − V⁻.
///
/// A solver is any callable const Collision& → Outcome<S>, with S float, double or long double. A solver that shows its
/// collision matrix returns SolvedOutcome<S>. Exact arithmetic checks the answer to a valid collision by the invariants
/// in `Property::invariants`. Rounding is permitted: inputs and outputs may be off by 32 units in the last place of the
/// solver's precision.
///
///     RC_GTEST_PROP(MySolver, NeverPenetrates, (const carom::Collision& collision)) {
///       RC_ASSERT(carom::properties::non_penetrating_post_velocity(my_solver, collision));
///     }
namespace carom::properties {

struct Property {
  std::string_view name;       // a key in lower case, with underscores
  std::string_view title;      // in words
  std::string_view statement;  // one sentence
  /// The invariants of `all_invariants()` that judge the property. The theorems of these invariants (`Proof`,
  /// invariants/proof.hpp) prove it.
  std::vector<std::string_view> invariants;
};

/// Non-penetrating post-velocity, positive definiteness of C, and conservation of momentum.
[[nodiscard]] std::span<const Property> three_properties();

struct Ruling {
  bool holds = true;
  bool is_in_domain = true;  // if false, `holds` is true
  std::string text = {};     // what is violated, or why the collision is outside the property's domain

  explicit operator bool() const { return holds; }
};

inline void showValue(const Ruling& ruling, std::ostream& out) { out << (ruling.holds ? "it holds" : ruling.text); }

namespace detail {

/// Judges an answer by the property of this name. Preconditions: `three_properties()` contains it; the collision is
/// valid.
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

// Pass `precision` if the solver computes in another precision than S.

/// After the impulse, the bodies do not approach at the contact: N·V⁺ ≥ 0. The domain is contacts with a movable body.
template <class Solver>
[[nodiscard]] Ruling non_penetrating_post_velocity(Solver&& solver, const Collision& collision,
                                                   std::optional<Precision> precision = std::nullopt) {
  return detail::ruling("non_penetrating_post_velocity", collision, solver(collision), precision);
}

/// The collision matrix C [1/kg, world axes] is symmetric and positive definite, with λI ⪯ C and λ = 1/m_A + 1/m_B > 0.
/// It also fits the answer: C F = V⁺ − V⁻. The domain is contacts with a movable body, if the solver shows C.
template <class Solver>
[[nodiscard]] Ruling positive_definiteness(Solver&& solver, const Collision& collision,
                                           std::optional<Precision> precision = std::nullopt) {
  const auto answer = solver(collision);
  static_assert(
      requires { answer.collision_matrix; }, "the solver must return SolvedOutcome, with its matrix");
  return detail::ruling("positive_definiteness", collision, answer, precision);
}

/// One body gains the linear momentum that the other loses: m_A Δv_A = −m_B Δv_B. The moment of its impulse turns each
/// movable body: J Δw = r × (m Δv). So the angular momentum about every point is kept. If a body is immovable, only the
/// second equation applies, to the other body.
template <class Solver>
[[nodiscard]] Ruling momentum_conservation(Solver&& solver, const Collision& collision,
                                           std::optional<Precision> precision = std::nullopt) {
  return detail::ruling("momentum_conservation", collision, solver(collision), precision);
}

}  // namespace carom::properties
