// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/judge/lifted_outcome.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/oracles/numbers/components.hpp>
#include <carom/oracles/numbers/norm.hpp>

namespace carom::oracles {

/// Whether ‖v‖ ≤ bound: always decided for rationals, for numbers known to within an error where the errors decide it.
/// Precondition: the bound is finite.
[[nodiscard]] bool norm_at_most(std::span<const Rational> vector, double bound);
[[nodiscard]] std::optional<bool> norm_at_most(std::span<const Enclosure> vector, double bound);
[[nodiscard]] std::optional<bool> norm_at_most(std::span<const Approximation> vector, double bound);

/// For print.
[[nodiscard]] inline double rounded(const Rational& number) { return to_double(number); }
[[nodiscard]] inline double rounded(const Enclosure& number) { return number.middle(); }
[[nodiscard]] inline double rounded(const Approximation& number) { return number.middle(); }

/// ‖v‖, rounded.
template <class T>
[[nodiscard]] double norm(const Components<T>& vector) {
  return root_of_squares(vector.size(), [&](std::size_t i) { return rounded(vector[i]); });
}

enum class Relation { equal, at_least, at_most };

/// A law held against an outcome. The decision is exact; the numbers are for print.
struct Comparison {
  bool holds = true;
  bool is_decided = true;  // false where the scale, or what is allowed of it, leaves the range of numbers
  // Where it does not hold:
  double residual = 0;  // ‖left − right‖, or by how much the inequality is missed
  double allowed = 0;   // what rounding may make of it
  std::vector<double> left;
  std::vector<double> right;
};

/// ‖∂g/∂ŷ_k‖ of a law of judged_laws.hpp that is affine in the outcome, as the scale has them: they do not depend on
/// the outcome. Defined in compare.hpp.
template <class Law>
[[nodiscard]] std::array<double, 4> slopes_of(const Law& law, const Collision& collision);

/// Holds a law of judged_laws.hpp against an outcome: exactly evaluated, and allowed yardstick.allowance() times its
/// scale. It then holds for inputs and outputs within that distance. A filtered yardstick has it decided by the
/// cheapest of these that can: approximations and a lower bound of the scale; enclosures and that bound; enclosures and
/// the scale; rationals. Defined in compare.hpp, which a law that is not among those needs to include.
template <class Law>
[[nodiscard]] Comparison compare(const Law& law, Relation relation, const ExactCase& exact_case,
                                 const LiftedOutcome& outcome, const Yardstick& yardstick);

/// How far an outcome is from the truth.
struct Accuracy {
  std::array<double, 4> error{};                 // ‖ŷ_k − y_k‖
  std::array<double, 4> error_above = infinite;  // at least the error; infinite where the judge is not filtered
  Sensitivity sensitivity{};                     // Σ_j ‖∂y_k/∂x_j‖ |x_j| + ‖y_k⁻‖
  bool is_decided = true;  // false where the sensitivity, or what is allowed of it, leaves the range of numbers: then
                           // nothing else here means anything
  std::array<bool, 4> allowed{true, true, true, true};  // whether the error is within the yardstick
  bool has_digits = true;  // relative_error ≤ 10^−digits, decided exactly; where the yardstick gives digits
  double relative_error = 0;  // ‖Δ − Δ_exact‖ / ‖Δ_exact‖ in the kinetic-energy norm, Δ the change of the velocities;
                              // infinite where Δ_exact = 0 and Δ is not

  /// η = max_k of error over u times sensitivity: by how many ulps the inputs would have to move to make it exact.
  [[nodiscard]] double backward_error(double unit_roundoff) const;

  /// Correct digits of the change of the velocities; at most 40, which stands for exact.
  [[nodiscard]] double digits() const;

 private:
  static constexpr std::array<double, 4> infinite{HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
};

/// Precondition: the model is one of `models_with_truth`. Where the backward error is surely at most `known`, by a
/// filtered yardstick, the sensitivity may be a lower bound in place of the number itself, at a small part of the cost:
/// the backward error then comes out too large, but at most `known`.
[[nodiscard]] Accuracy accuracy(const ExactCase& exact_case, Model model, const LiftedOutcome& outcome,
                                const Yardstick& yardstick, double known = 0);

}  // namespace carom::oracles
