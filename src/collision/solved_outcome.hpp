// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/collision/outcome.hpp>
#include <carom/collision/vector.hpp>

namespace carom {

/// An outcome, and the collision matrix with which the solver found it, in world axes [1/kg]. The matrix is absent if
/// the solver does not report it. A solver that claims to report it reports it for each colliding contact.
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

/// Writes the velocities into `into`, because copies of long doubles are slow. `into` keeps its collision matrix.
template <class S>
void write_reported(const Outcome<S>& outcome, ReportedOutcome& into) {
  const auto from = vectors(outcome);
  const auto to = vectors(into);
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      (*to[k])[i] = static_cast<long double>((*from[k])[i]);
    }
  }
}

template <class S>
[[nodiscard]] ReportedOutcome reported(const Outcome<S>& outcome) {
  ReportedOutcome result;
  write_reported(outcome, result);
  return result;
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
