// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/collision/precision.hpp>
#include <carom/collision/solved_outcome.hpp>
#include <carom/oracles/judge/yardstick.hpp>

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
  /// invariants/invariant.hpp) prove it.
  std::vector<std::string_view> invariants;
};

/// Non-penetrating post-velocity, positive definiteness of C, and conservation of momentum.
[[nodiscard]] std::span<const Property> three_properties();

struct PropertyOptions {
  std::optional<Precision> precision = {};          // in which the solver computes; by default that of S
  double limit_ulps = oracles::default_limit_ulps;  // in units in the last place of the precision
  std::optional<int> digits = {};                   // permits a relative error of 10^-digits, in place of limit_ulps
  /// The domain for which the solver is meant: "games", or another text that `domain_from` reads. A collision outside
  /// of it is outside the property's domain. Empty for everything.
  std::string within = {};
  /// Changes of the law's answer that the solver makes on purpose. The names are those of the protocol:
  /// {{"restitution_threshold", 0.5}}. Limits of speeds need a law, so they are not permitted here.
  std::map<std::string, double> effects = {};
};

struct Ruling {
  bool holds = true;
  bool is_in_domain = true;  // if false, nothing was judged, and `holds` is true
  std::string text = {};     // what is violated, or why the collision is outside the property's domain
  /// The solver's fault, in at most ten lines (properties/diagnosis). Empty if the property holds. Asks the solver this
  /// collision again, and some that differ in their velocities alone.
  std::function<std::string()> diagnosis = {};

  explicit operator bool() const { return holds; }
};

inline void showValue(const Ruling& ruling, std::ostream& out) {
  out << (ruling.holds ? "it holds" : ruling.text) << (ruling.diagnosis ? ruling.diagnosis() : "");
}

namespace detail {

template <class S>
S scalar_of(const Outcome<S>&);

struct PropertyAnswer {
  std::string_view property;  // a name in `three_properties()`
  Collision collision;        // valid
  ReportedOutcome answer;
  Precision precision;
};

/// The ruling, without a diagnosis. Throws std::invalid_argument if an option is wrong.
[[nodiscard]] Ruling ruling(const PropertyAnswer& answered, const PropertyOptions& options);

using Ask = std::function<ReportedOutcome(const Collision&)>;

/// The diagnosis of a violating answer. `ask` asks the same solver.
[[nodiscard]] std::string diagnosed(const PropertyAnswer& answered, const PropertyOptions& options, const Ask& ask);

template <class Solver>
[[nodiscard]] Ruling ruling(std::string_view property, Solver& solver, const Collision& collision,
                            const PropertyOptions& options) {
  const auto answer = solver(collision);
  using S = decltype(scalar_of(answer));
  const PropertyAnswer answered{property, collision, reported(answer), options.precision.value_or(precision_of<S>)};
  Ruling ruled = ruling(answered, options);
  // The ruling may outlive the solver, so the diagnosis has a copy.
  if constexpr (std::is_copy_constructible_v<std::decay_t<Solver>>) {
    if (!ruled.holds) {
      ruled.diagnosis = [answered, options, own = std::decay_t<Solver>(solver)] {
        std::decay_t<Solver> asked = own;
        return diagnosed(answered, options, [&](const Collision& one) { return reported(asked(one)); });
      };
    }
  }
  return ruled;
}

}  // namespace detail

/// After the impulse, the bodies do not approach at the contact: N·V⁺ ≥ 0. The domain is contacts with a movable body.
template <class Solver>
[[nodiscard]] Ruling non_penetrating_post_velocity(Solver&& solver, const Collision& collision,
                                                   const PropertyOptions& options = {}) {
  return detail::ruling("non_penetrating_post_velocity", solver, collision, options);
}

/// The collision matrix C [1/kg, world axes] is symmetric and positive definite, with λI ⪯ C and λ = 1/m_A + 1/m_B > 0.
/// It also fits the answer: C F = V⁺ − V⁻. The domain is contacts with a movable body. An answer to a colliding contact
/// violates the property if it shows no C. The answers to other contacts may leave it out.
template <class Solver>
[[nodiscard]] Ruling positive_definiteness(Solver&& solver, const Collision& collision,
                                           const PropertyOptions& options = {}) {
  static_assert(
      requires { solver(collision).collision_matrix; }, "the solver must return SolvedOutcome, with its matrix");
  return detail::ruling("positive_definiteness", solver, collision, options);
}

/// One body gains the linear momentum that the other loses: m_A Δv_A = −m_B Δv_B. The moment of its impulse turns each
/// movable body: J Δw = r × (m Δv). So the angular momentum about every point is kept. If a body is immovable, only the
/// second equation applies, to the other body.
template <class Solver>
[[nodiscard]] Ruling momentum_conservation(Solver&& solver, const Collision& collision,
                                           const PropertyOptions& options = {}) {
  return detail::ruling("momentum_conservation", solver, collision, options);
}

}  // namespace carom::properties
