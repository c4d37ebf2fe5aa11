// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties::diagnosis {

/// What a law answers, to the nearest binary64 numbers or so.
struct LawAnswer {
  Outcome<double> outcome;
  Vector3<double> impulse;  // on A
};

/// To a collision as it approaches, or as if it approached otherwise. Preconditions: it is valid, and the law
/// determines an outcome.
[[nodiscard]] LawAnswer law_answer(const Collision& collision, Law law, std::optional<oracles::Approach> approach = {});

/// A case that was answered by an outcome, and what the law answers.
struct KnownCase {
  Collision collision;
  Law law = Law::any;
  oracles::Approach approach = oracles::Approach::inert;
  Outcome<double> before;
  Outcome<double> answered;
  Outcome<double> truth;    // nearest binary64 numbers
  Vector3<double> impulse;  // of the law, on A
};

/// None where the collision is invalid, the answer is no outcome of finite numbers, or the law determines none.
[[nodiscard]] std::optional<KnownCase> known_case(const ViolatedCase& violated, Law law);

/// The square root of Σ m ‖δv‖² + δwᵀ J δw over the movable bodies, of the difference of two outcomes: twice its
/// kinetic energy, so that velocities and spins can be compared. [√J]
[[nodiscard]] double energy_distance(const Collision& collision, const Outcome<double>& x, const Outcome<double>& y);

/// Whether the outcome is so far off that more than rounding is to be seen in it, in arithmetic of this unit roundoff.
[[nodiscard]] bool is_visibly_off(const KnownCase& one, double unit_roundoff);

/// The velocities that the impulse gives to both bodies: v ± F/m, w ± J⁻¹(r × F), of the movable ones.
[[nodiscard]] Outcome<double> pushed(const Collision& collision, const Vector3<double>& impulse);

}  // namespace carom::properties::diagnosis
