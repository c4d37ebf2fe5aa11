// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <carom/oracles/inputs.hpp>
#include <carom/oracles/judge.hpp>
#include <carom/oracles/laws.hpp>
#include <carom/oracles/stage.hpp>

/// How a law is held against an outcome.
namespace carom::oracles {

namespace detail {

/// What is left of left − right once what an inequality permits is taken away.
template <class T, int N, class IsPermitted>
[[nodiscard]] Components<T> missed(const Sides<T, N>& sides, Relation relation, const IsPermitted& is_permitted) {
  Components<T> all = difference(sides.left, sides.right);
  if (relation == Relation::equal) {
    return all;
  }
  const int permitted_sign = relation == Relation::at_least ? 1 : -1;
  Components<T> result;
  for (const T& x : all) {
    if (!is_permitted(x, permitted_sign)) {
      result.push_back(x);
    }
  }
  return result;
}

/// The same of numbers known to within an error: what may be missing counts.
template <class Law, class T>
[[nodiscard]] Components<T> maybe_missed(const Law& law, Relation relation, const BasicCollision<T>& collision,
                                         const Outcome<T>& outcome) {
  return missed(law(collision, outcome), relation,
                [](const T& x, int sign) { return x.sign().value_or(-sign) != -sign; });
}

/// ‖∂g/∂x_j‖, g = left − right. Hypotenuses: squares would leave the range of numbers long before the scale does.
template <class S, std::size_t N, int Size>
[[nodiscard]] S norm_of_derivative(const Sides<Dual<S, N>, Size>& sides, std::size_t input) {
  S norm(0);
  for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
    norm = std::hypot(norm, sides.left[i].derivative[input] - sides.right[i].derivative[input]);
  }
  return norm;
}

/// ‖∂g/∂ŷ_k‖ of the four vectors of an outcome, whose numbers are the inputs from this one on.
template <class S, std::size_t N, int Size>
[[nodiscard]] std::array<S, 4> output_slopes(const Sides<Dual<S, N>, Size>& sides, std::size_t first_output) {
  std::array<S, 4> slopes{};
  for (std::size_t input = 0; input < outcome_inputs; ++input) {
    S& slope = slopes[input / 3];
    slope = std::hypot(slope, norm_of_derivative(sides, first_output + input));
  }
  return slopes;
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
  S scale(0);
  for (std::size_t j = 0; j < inputs.magnitude.size(); ++j) {
    scale += norm_of_derivative(sides, j) * static_cast<S>(inputs.magnitude[j]);
  }
  const std::array<S, 4> slopes = output_slopes(sides, first_output);
  const Outcome<double> before = unchanged(collision);
  const auto initial = vectors(before);
  const auto computed = vectors(outcome);
  for (std::size_t k = 0; k < computed.size(); ++k) {
    scale += slopes[k] * static_cast<S>(computed[k]->stableNorm() + initial[k]->stableNorm());
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

/// The sum over the outputs alone: a lower bound of the scale, at a quarter of the cost. Of a law that is affine in the
/// outcome the derivatives, as computed, do not depend on the outcome (they are multiplied by numbers of the collision
/// alone; what the product rule adds is zero), so the case keeps them; the factor is for the order of the summation.
/// Precondition: collision and outcome are moderate.
template <class Law>
[[nodiscard]] double part_of_scale(const Law& law, const ExactCase& exact_case, const LiftedOutcome& outcome) {
  const Collision& collision = exact_case.collision();
  double part = 0;
  if (const std::optional<AffineLaw> name = law.name()) {
    const std::array<double, 4>& slopes = exact_case.slopes(*name, [&] { return slopes_of(law, collision); });
    const std::array<double, 4> norms = outcome.norms();
    for (std::size_t k = 0; k < slopes.size(); ++k) {
      part += slopes[k] * (norms[k] + exact_case.norms_before()[k]);
    }
    part *= 1 - 0x1p-40;
  } else {
    part = scale_in<double, outcome_inputs>(law, collision, outcome.rounded(), false);
  }
  return is_in_range(part) ? part : 0;
}

/// Whether approximations alone show that the law holds; where they do not, nothing is known.
template <class Law>
[[nodiscard]] bool surely_holds(const Law& law, Relation relation, const ExactCase& exact_case,
                                const LiftedOutcome& outcome, double allowance) {
  if (allowance < least_allowance_for_approximations || !exact_case.is_moderate() || !outcome.is_moderate()) {
    return false;
  }
  const auto missed = maybe_missed(law, relation, exact_case.approximate(), outcome.approximate());
  return missed.empty() || norm_at_most(missed, allowance * part_of_scale(law, exact_case, outcome)).value_or(false);
}

/// Both sides and by how much they miss each other, rounded for print.
template <class T, int N>
[[nodiscard]] Comparison violation(const Sides<T, N>& sides, const Components<T>& missed, double allowed) {
  Comparison comparison{false, true, norm(missed), allowed, {}, {}};
  for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
    comparison.left.push_back(rounded(sides.left[i]));
    comparison.right.push_back(rounded(sides.right[i]));
  }
  return comparison;
}

}  // namespace detail

template <class Law>
[[nodiscard]] std::array<double, 4> slopes_of(const Law& law, const Collision& collision) {
  using T = Dual<double, outcome_inputs>;
  std::size_t next = 0;
  return detail::output_slopes(law(map_numbers<T>(collision, [](double x) { return T(x); }),
                                   map_outcome<T>(unchanged(collision), [&](double x) { return T::input(x, next++); })),
                               0);
}

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
  if (yardstick.uses_bounds()) {
    if (detail::surely_holds(law, relation, exact_case, outcome, allowance)) {
      count(Stage::approximation);
      return {};
    }
    const auto missed = detail::maybe_missed(law, relation, exact_case.enclosed(), outcome.enclosed());
    // Elsewhere the whole scale may leave the range of numbers where a part of it does not.
    const bool is_moderate = exact_case.is_moderate() && outcome.is_moderate();
    if (missed.empty() ||
        (is_moderate &&
         norm_at_most(missed, allowance * detail::part_of_scale(law, exact_case, outcome)).value_or(false))) {
      count(Stage::enclosure);
      return {};
    }
    const std::optional<double> bound = allowed();
    const std::optional<bool> within = bound ? norm_at_most(missed, *bound) : std::nullopt;
    if (within) {
      count(Stage::enclosure);
      return *within ? Comparison{} : detail::violation(law(exact_case.enclosed(), outcome.enclosed()), missed, *bound);
    }
  }
  count(Stage::rational);
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

}  // namespace carom::oracles
