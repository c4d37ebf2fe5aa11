// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties::diagnosis {

/// A law's answer in binary64. Each number is the nearest, or within one or two roundings of it.
struct LawAnswer {
  Outcome<double> outcome;
  Vector3<double> impulse;  // on A
};

/// The law's answer to a collision. `approach` replaces the collision's own approach. Preconditions: the collision is
/// valid; the law determines an outcome.
[[nodiscard]] LawAnswer law_answer(const Collision& collision, Law law, std::optional<oracles::Approach> approach = {});

/// A case that has an outcome as its answer, with the law's answer.
struct KnownCase {
  Collision collision;
  Law law = Law::any;
  oracles::Approach approach = oracles::Approach::inert;
  Outcome<double> before;
  Outcome<double> answered;
  Outcome<double> truth;    // nearest binary64 numbers
  Vector3<double> impulse;  // of the law, on A
};

/// No value if the collision is invalid, the answer is not an outcome of finite numbers, or the law determines no
/// outcome.
[[nodiscard]] std::optional<KnownCase> known_case(const ViolatedCase& violated, Law law);

/// The square root of Σ m ‖δv‖² + δwᵀ J δw over the movable bodies, for the difference of two outcomes [√J]. Its square
/// is twice the kinetic energy of the difference. It makes velocities and angular velocities comparable.
[[nodiscard]] double energy_distance(const Collision& collision, const Outcome<double>& x, const Outcome<double>& y);

/// Whether the outcome is so far off that rounding alone does not explain it, for arithmetic with this unit roundoff.
[[nodiscard]] bool is_visibly_off(const KnownCase& one, double unit_roundoff);

/// The velocities that the impulse gives to the movable bodies: v ± F/m, w ± J⁻¹(r × F).
[[nodiscard]] Outcome<double> pushed(const Collision& collision, const Vector3<double>& impulse);

}  // namespace carom::properties::diagnosis
