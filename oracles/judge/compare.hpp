// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/oracles/filters/lifted_outcome.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/judge/yardstick.hpp>

namespace carom::oracles {

/// Scales between these limits can be multiplied by an allowance without leaving the range of binary64.
inline constexpr double smallest_scale = 0x1p-900;
inline constexpr double largest_scale = 0x1p+1000;

enum class Relation { equal, at_least, at_most };

/// The result of comparing the two sides of an equation at an outcome. The decision is exact. The numbers are for
/// print.
struct Comparison {
  bool holds = true;
  bool is_decided = true;  // false if the scale, or the allowance times it, leaves the range of numbers
  // The members below are set if the equation does not hold.
  double residual = 0;  // ‖left − right‖, or the amount by which the inequality fails
  double allowed = 0;   // the residual that rounding may cause
  std::vector<double> left;
  std::vector<double> right;
};

/// Evaluates an equation exactly at an outcome. The residual may be at most yardstick.allowance() times the scale of
/// the equation. The equation then holds for inputs and outputs within that distance. A filtered yardstick uses the
/// first of these that decides: approximations and a lower bound of the scale; enclosures and that bound; enclosures
/// and the scale; rationals. Precondition: the equation applies to this collision.
[[nodiscard]] Comparison compare(const Equation& equation, Relation relation, const ExactCase& exact_case,
                                 const LiftedOutcome& outcome, const Yardstick& yardstick);

/// Compares V⁺ − V⁻ with C F in the same way, for the collision matrix C that a subject shows. C may differ from K by
/// as much as the permitted inputs can change K. F is computed from the velocity change of the lighter movable body.
/// Preconditions: a body is movable; C is finite.
[[nodiscard]] Comparison compare_change_by(const LiftedMatrix& shown, const ExactCase& exact_case,
                                           const LiftedOutcome& outcome, const Yardstick& yardstick);

}  // namespace carom::oracles
