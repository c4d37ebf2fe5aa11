// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include <carom/oracles/exact_case.hpp>
#include <carom/oracles/inputs.hpp>
#include <carom/oracles/laws.hpp>
#include <carom/oracles/yardstick.hpp>

namespace carom::oracles {

enum class Relation { equal, at_least, at_most };

/// A law held against an outcome. The residual is exact (rounded for print alone), and so is the decision.
struct Comparison {
  bool holds = true;
  double residual = 0;        // ‖left − right‖, or by how much the inequality is missed
  double allowed = 0;         // what rounding may make of it; 0 where the residual is exactly zero and it was not asked
  std::vector<double> left;   // both sides, where it does not hold
  std::vector<double> right;
};

namespace detail {

inline constexpr std::size_t judged_inputs = collision_inputs + outcome_inputs;

/// Σ_j ‖∂g/∂x_j‖ |x_j| + Σ_k ‖∂g/∂ŷ_k‖ ‖ŷ_k‖ with g = left − right.
template <class S, class Law>
[[nodiscard]] double scale_in(const Law& law, const Collision& collision, const Outcome<double>& outcome) {
  using T = Dual<S, judged_inputs>;
  const auto inputs = dual_inputs<S, judged_inputs>(collision, [](double x) { return static_cast<S>(x); });
  std::size_t next = collision_inputs;
  const auto dual_outcome =
      map_outcome<T>(outcome, [&](double number) { return T::input(static_cast<S>(number), next++); });
  const auto sides = law(inputs.collision, dual_outcome);
  const auto size = static_cast<std::size_t>(sides.left.size());
  const auto squared_derivative = [&](std::size_t input) {
    S sum(0);
    for (std::size_t i = 0; i < size; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const S derivative = sides.left[row].derivative[input] - sides.right[row].derivative[input];
      sum += derivative * derivative;
    }
    return sum;
  };
  S scale(0);
  for (std::size_t j = 0; j < inputs.magnitude.size(); ++j) {
    scale += std::sqrt(squared_derivative(j)) * static_cast<S>(inputs.magnitude[j]);
  }
  const auto parts = vectors(outcome);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    S squared(0);
    for (std::size_t i = 0; i < 3; ++i) {
      squared += squared_derivative(collision_inputs + 3 * k + i);
    }
    scale += std::sqrt(squared) * static_cast<S>(parts[k]->norm());
  }
  return static_cast<double>(scale);
}

template <class Law>
[[nodiscard]] double scale_of(const Law& law, const Collision& collision, const Outcome<Rational>& outcome) {
  const auto rounded = map_outcome<double>(outcome, [](const Rational& x) { return to_double(x); });
  const double scale = scale_in<double>(law, collision, rounded);
  if (std::isfinite(scale) && scale > 0) {
    return scale;
  }
  // Products of extreme numbers leave the range of binary64; extended has the same bits and more range.
  return scale_in<long double>(law, collision, rounded);
}

}  // namespace detail

/// Holds a law (collision, outcome) → Sides, given for any field, against an outcome: exactly evaluated, and allowed
/// `allowance` times its scale (mathematics: the residual vanishes for inputs and outputs within that distance).
template <class Law>
[[nodiscard]] Comparison compare(const Law& law, Relation relation, const ExactCase& exact_case,
                                 const Outcome<Rational>& outcome, double allowance) {
  const auto sides = law(exact_case.exact(), outcome);
  Comparison comparison;
  Rational squared(0);
  for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
    const Rational difference = sides.left[i] - sides.right[i];
    const bool counts = relation == Relation::equal ? difference != 0
                                                    : (relation == Relation::at_least ? difference < 0 : difference > 0);
    if (counts) {
      squared += difference * difference;
    }
  }
  if (squared == 0) {
    return comparison;
  }
  comparison.residual = std::sqrt(to_double(squared));
  if (allowance > 0) {
    comparison.allowed = allowance * detail::scale_of(law, exact_case.collision(), outcome);
  }
  comparison.holds = !std::isfinite(comparison.allowed) ||
                     squared <= Rational(comparison.allowed) * Rational(comparison.allowed);
  if (!comparison.holds) {
    for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
      comparison.left.push_back(to_double(sides.left[i]));
      comparison.right.push_back(to_double(sides.right[i]));
    }
  }
  return comparison;
}

/// How far an outcome is from the truth.
struct Accuracy {
  std::array<double, 4> error{};         // ‖ŷ_k − y_k‖
  std::array<double, 4> sensitivity{};   // Σ_j ‖∂y_k/∂x_j‖ |x_j|
  double relative_error = 0;  // ‖Δ − Δ_exact‖ / ‖Δ_exact‖ in the kinetic-energy norm, Δ the change of the velocities;
                              // infinite where Δ_exact = 0 and Δ is not

  /// η = max_k of error over u times sensitivity: by how many ulps the inputs would have to move to make it exact.
  [[nodiscard]] double backward_error(double unit_roundoff) const;

  /// Correct digits of the change of the velocities; at most 40, which stands for exact.
  [[nodiscard]] double digits() const;
};

/// Precondition: the model is one of `models_with_truth`.
[[nodiscard]] Accuracy accuracy(const ExactCase& exact_case, Model model, const Outcome<Rational>& outcome,
                                double allowance);

}  // namespace carom::oracles
