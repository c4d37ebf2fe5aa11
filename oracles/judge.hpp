// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <carom/oracles/exact_case.hpp>
#include <carom/oracles/inputs.hpp>
#include <carom/oracles/laws.hpp>
#include <carom/oracles/lifted_outcome.hpp>
#include <carom/oracles/yardstick.hpp>

namespace carom::oracles {

/// Whether ‖v‖ ≤ bound: always decided for rationals, for enclosures where the bounds decide it. Precondition: the
/// bound is finite.
[[nodiscard]] bool norm_at_most(const std::vector<Rational>& vector, double bound);
[[nodiscard]] std::optional<bool> norm_at_most(const std::vector<Enclosure>& vector, double bound);

/// For print.
[[nodiscard]] inline double rounded(const Rational& number) { return to_double(number); }
[[nodiscard]] inline double rounded(const Enclosure& number) { return number.middle(); }

/// ‖v‖, rounded.
template <class T>
[[nodiscard]] double norm(const std::vector<T>& vector) {
  double sum = 0;
  for (const T& component : vector) {
    sum = std::hypot(sum, rounded(component));
  }
  return sum;
}

/// The components of left − right.
template <class Derived, class OtherDerived>
[[nodiscard]] auto difference(const Eigen::MatrixBase<Derived>& left, const Eigen::MatrixBase<OtherDerived>& right) {
  std::vector<typename Derived::Scalar> result;
  for (Eigen::Index i = 0; i < left.size(); ++i) {
    result.push_back(left[i] - right[i]);
  }
  return result;
}

enum class Relation { equal, at_least, at_most };

/// A law held against an outcome. The decision is exact; the numbers are for print.
struct Comparison {
  bool holds = true;
  bool is_decided = true;  // false where the scale leaves the range of numbers
  // Where it does not hold:
  double residual = 0;  // ‖left − right‖, or by how much the inequality is missed
  double allowed = 0;   // what rounding may make of it
  std::vector<double> left;
  std::vector<double> right;
};

namespace detail {

/// What is left of left − right once what an inequality permits is taken away.
template <class T, int N, class IsPermitted>
[[nodiscard]] std::vector<T> missed(const Sides<T, N>& sides, Relation relation, const IsPermitted& is_permitted) {
  std::vector<T> result = difference(sides.left, sides.right);
  if (relation != Relation::equal) {
    const int permitted_sign = relation == Relation::at_least ? 1 : -1;
    std::erase_if(result, [&](const T& x) { return is_permitted(x, permitted_sign); });
  }
  return result;
}

/// Σ_k ‖∂g/∂ŷ_k‖ (‖ŷ_k‖ + ‖y_k⁻‖), and Σ_j ‖∂g/∂x_j‖ |x_j| over the numbers of the collision where these are inputs as
/// well. An output is its velocity before the impulse plus a change, and so is known to u times the larger of both: its
/// own size alone would allow nothing where the exact sum is zero.
template <class S, std::size_t N, class Law>
[[nodiscard]] S scale_in(const Law& law, const Collision& collision, const Outcome<double>& outcome,
                         bool with_collision) {
  using T = Dual<S, N>;
  DualInputs<S, N> inputs;
  if (with_collision) {
    inputs = dual_inputs<S, N>(collision, [](double x) { return static_cast<S>(x); });
  } else {
    inputs.collision = map_numbers<T>(collision, [](double x) { return T(static_cast<S>(x)); });
  }
  const std::size_t first_output = with_collision ? collision_inputs : 0;
  std::size_t next = first_output;
  const auto dual_outcome =
      map_outcome<T>(outcome, [&](double number) { return T::input(static_cast<S>(number), next++); });
  const auto sides = law(inputs.collision, dual_outcome);
  // Hypotenuses: squares would leave the range of numbers long before the scale does.
  const auto norm_of_derivative = [&](std::size_t input) {
    S norm(0);
    for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
      norm = std::hypot(norm, sides.left[i].derivative[input] - sides.right[i].derivative[input]);
    }
    return norm;
  };
  S scale(0);
  for (std::size_t j = 0; j < inputs.magnitude.size(); ++j) {
    scale += norm_of_derivative(j) * static_cast<S>(inputs.magnitude[j]);
  }
  const Outcome<double> before = unchanged(collision);
  const auto initial = vectors(before);
  const auto computed = vectors(outcome);
  for (std::size_t k = 0; k < computed.size(); ++k) {
    S norm(0);
    for (std::size_t i = 0; i < 3; ++i) {
      norm = std::hypot(norm, norm_of_derivative(first_output + 3 * k + i));
    }
    scale += norm * static_cast<S>(computed[k]->stableNorm() + initial[k]->stableNorm());
  }
  return scale;
}

/// Whether a scale can be multiplied by an allowance without leaving the range of binary64.
template <class S>
[[nodiscard]] bool is_in_range(S scale) {
  constexpr S smallest = 0x1p-900;
  constexpr S largest = 0x1p+1000;
  return scale >= smallest && scale <= largest;
}

/// Both sums, with g = left − right; none where it leaves the range of numbers.
template <class Law>
[[nodiscard]] std::optional<double> scale_of(const Law& law, const Collision& collision,
                                             const Outcome<double>& outcome) {
  constexpr std::size_t all_inputs = collision_inputs + outcome_inputs;
  const double scale = scale_in<double, all_inputs>(law, collision, outcome, true);
  if (is_in_range(scale)) {
    return scale;
  }
  // Products of extreme numbers leave the range of binary64; extended has the same bits and more range.
  const long double wide = scale_in<long double, all_inputs>(law, collision, outcome, true);
  return wide == 0 || is_in_range(wide) ? std::optional<double>(static_cast<double>(wide)) : std::nullopt;
}

/// The sum over the outputs alone: a lower bound of the scale, at a quarter of the cost.
template <class Law>
[[nodiscard]] double part_of_scale(const Law& law, const Collision& collision, const Outcome<double>& outcome) {
  const double part = scale_in<double, outcome_inputs>(law, collision, outcome, false);
  return is_in_range(part) ? part : 0;
}

/// Both sides and by how much they miss each other, rounded for print.
template <class T, int N>
[[nodiscard]] Comparison violation(const Sides<T, N>& sides, const std::vector<T>& missed, double allowed) {
  Comparison comparison{false, true, norm(missed), allowed, {}, {}};
  for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
    comparison.left.push_back(rounded(sides.left[i]));
    comparison.right.push_back(rounded(sides.right[i]));
  }
  return comparison;
}

}  // namespace detail

/// Holds a law, (collision, outcome) → Sides in any field, against an outcome: exactly evaluated, and allowed
/// yardstick.allowance() times its scale. It then holds for inputs and outputs within that distance.
template <class Law>
[[nodiscard]] Comparison compare(const Law& law, Relation relation, const ExactCase& exact_case,
                                 const LiftedOutcome& outcome, const Yardstick& yardstick) {
  const double allowance = yardstick.allowance();
  std::optional<double> scale;
  const auto allowed = [&]() -> std::optional<double> {
    if (allowance == 0) {
      return 0;
    }
    if (!scale) {
      scale = detail::scale_of(law, exact_case.collision(), outcome.rounded());
    }
    return scale ? std::optional<double>(allowance * *scale) : std::nullopt;
  };
  if (yardstick.filtered && allowance > 0) {
    const auto missed = detail::missed(law(exact_case.enclosed(), outcome.enclosed()), relation,
                                       [](const Enclosure& x, int sign) { return x.sign().value_or(-sign) != -sign; });
    if (missed.empty() ||
        norm_at_most(missed, allowance * detail::part_of_scale(law, exact_case.collision(), outcome.rounded()))
            .value_or(false)) {
      return {};
    }
    const std::optional<double> bound = allowed();
    const std::optional<bool> within = bound ? norm_at_most(missed, *bound) : std::nullopt;
    if (within) {
      return *within ? Comparison{} : detail::violation(law(exact_case.enclosed(), outcome.enclosed()), missed, *bound);
    }
  }
  const auto sides = law(exact_case.exact(), outcome.exact());
  const auto missed = detail::missed(sides, relation, [](const Rational& x, int sign) { return x * sign >= 0; });
  if (missed.empty() || norm_at_most(missed, 0)) {
    return {};
  }
  const std::optional<double> bound = allowed();
  if (!bound) {
    return {true, false, 0, 0, {}, {}};
  }
  if (norm_at_most(missed, *bound)) {
    return {};
  }
  return detail::violation(sides, missed, *bound);
}

/// How far an outcome is from the truth.
struct Accuracy {
  std::array<double, 4> error{};                        // ‖ŷ_k − y_k‖
  Sensitivity sensitivity{};                            // Σ_j ‖∂y_k/∂x_j‖ |x_j| + ‖y_k⁻‖
  bool is_decided = true;                               // false where the sensitivity leaves the range of numbers
  std::array<bool, 4> allowed{true, true, true, true};  // whether the error is within the yardstick
  double relative_error = 0;  // ‖Δ − Δ_exact‖ / ‖Δ_exact‖ in the kinetic-energy norm, Δ the change of the velocities;
                              // infinite where Δ_exact = 0 and Δ is not

  /// η = max_k of error over u times sensitivity: by how many ulps the inputs would have to move to make it exact.
  [[nodiscard]] double backward_error(double unit_roundoff) const;

  /// Correct digits of the change of the velocities; at most 40, which stands for exact.
  [[nodiscard]] double digits() const;
};

/// Precondition: the model is one of `models_with_truth`.
[[nodiscard]] Accuracy accuracy(const ExactCase& exact_case, Model model, const LiftedOutcome& outcome,
                                const Yardstick& yardstick);

}  // namespace carom::oracles
