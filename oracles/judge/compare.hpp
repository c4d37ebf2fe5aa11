// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/oracles/filters/lifted_outcome.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/judge/yardstick.hpp>

namespace carom::oracles {

/// Scales in between can be multiplied by an allowance without leaving the range of binary64.
inline constexpr double smallest_scale = 0x1p-900;
inline constexpr double largest_scale = 0x1p+1000;

enum class Relation { equal, at_least, at_most };

/// An equation held against an outcome. The decision is exact; the numbers are for print.
struct Comparison {
  bool holds = true;
  bool is_decided = true;  // false where the scale, or what is allowed of it, leaves the range of numbers
  // Where it does not hold:
  double residual = 0;  // ‖left − right‖, or by how much the inequality is missed
  double allowed = 0;   // what rounding may make of it
  std::vector<double> left;
  std::vector<double> right;
};

/// Holds an equation against an outcome: exactly evaluated, and allowed yardstick.allowance() times its scale. It then
/// holds for inputs and outputs within that distance. A filtered yardstick has it decided by the cheapest of these that
/// can: approximations and a lower bound of the scale; enclosures and that bound; enclosures and the scale; rationals.
/// Precondition: the equation speaks of this collision.
[[nodiscard]] Comparison compare(const Equation& equation, Relation relation, const ExactCase& exact_case,
                                 const LiftedOutcome& outcome, const Yardstick& yardstick);

/// The same of V⁺ − V⁻ = C F for the collision matrix C that a subject shows, which may itself be off by what the
/// inputs can move K by. F is read off the lighter movable body. Preconditions: a body is movable; C is finite.
[[nodiscard]] Comparison compare_change_by(const LiftedMatrix& shown, const ExactCase& exact_case,
                                           const LiftedOutcome& outcome, const Yardstick& yardstick);

}  // namespace carom::oracles
