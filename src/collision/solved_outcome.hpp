// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/collision/outcome.hpp>
#include <carom/collision/vector.hpp>

namespace carom {

/// An outcome, and the collision matrix with which the solver found it, in world axes [1/kg]. The matrix is absent if
/// the solver formed none or does not report it.
template <class S>
struct SolvedOutcome : Outcome<S> {
  std::optional<Matrix3<S>> collision_matrix;

  SolvedOutcome() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): an outcome converts to one without a matrix
  SolvedOutcome(const Outcome<S>& outcome, const std::optional<Matrix3<S>>& matrix = std::nullopt)
      : Outcome<S>(outcome), collision_matrix(matrix) {}
  SolvedOutcome(const BodyVelocity<S>& of_a, const BodyVelocity<S>& of_b) : Outcome<S>{of_a, of_b} {}
};

/// An outcome as a subject reports it. It holds binary32, binary64 and extended numbers without rounding.
using ReportedOutcome = SolvedOutcome<long double>;

template <class S>
[[nodiscard]] ReportedOutcome reported(const Outcome<S>& outcome) {
  return map_outcome<long double>(outcome, [](S number) { return static_cast<long double>(number); });
}

template <class S>
[[nodiscard]] ReportedOutcome reported(const SolvedOutcome<S>& solved) {
  ReportedOutcome outcome = reported(static_cast<const Outcome<S>&>(solved));
  if (solved.collision_matrix) {
    outcome.collision_matrix = solved.collision_matrix->template cast<long double>();
  }
  return outcome;
}

}  // namespace carom
