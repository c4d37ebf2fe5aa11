// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/oracles/bounds/lifted_outcome.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/judge/yardstick.hpp>

namespace carom::oracles {

/// If a scale (yardstick.hpp) is between these limits, its product with an allowance stays in the range of binary64.
inline constexpr double smallest_scale = 0x1p-900;
inline constexpr double largest_scale = 0x1p+1000;

enum class EquationForm { equal, at_least, at_most };

/// The comparison of the two sides of an equation at an outcome. The decision is exact. The numbers are rounded, for
/// print.
struct EquationCheck {
  bool holds = true;
  bool is_decided = true;  // false if the scale, or the allowance times it, leaves the range of numbers
  // The members below are set if the equation does not hold.
  double residual = 0;  // ‖left − right‖, or the amount by which the inequality fails
  double allowed = 0;   // the residual that rounding may cause
  std::vector<double> left = {};
  std::vector<double> right = {};
};

/// Decides exactly whether an equation holds at an outcome: the residual is at most yardstick.allowance() times the
/// scale, and more in a hard case (permitted_residual.hpp). With a filtered yardstick, `compare` tries in turn:
/// enclosures with a lower bound of the scale; enclosures with the scale; rationals. Precondition: that of the equation
/// (equations.hpp).
[[nodiscard]] EquationCheck compare(const Equation& equation, EquationForm form, const ExactCase& exact_case,
                                    const LiftedOutcome& outcome, const Yardstick& yardstick);

/// Compares V⁺ − V⁻ with C F as `compare` does, for the collision matrix C that a subject reports. C may differ from
/// the exact K by as much as permitted inputs (permitted_inputs.hpp) change K. The velocity change of the lighter
/// movable body gives F. Preconditions: a body is movable; shown.is_finite().
[[nodiscard]] EquationCheck compare_change_by(const LiftedMatrix& shown, const ExactCase& exact_case,
                                              const LiftedOutcome& outcome, const Yardstick& yardstick);

}  // namespace carom::oracles
