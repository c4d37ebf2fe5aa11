// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <carom/oracles/filters/stage.hpp>
#include <carom/oracles/judge/judge.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/numbers/inputs.hpp>
#include <carom/oracles/numbers/norm.hpp>

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

/// ‖∂g/∂x_j‖, g = left − right.
template <class S, std::size_t N, int Size>
[[nodiscard]] S norm_of_derivative(const Sides<Dual<S, N>, Size>& sides, std::size_t input) {
  return root_of_squares(Size, [&](std::size_t i) -> S {
    const auto row = static_cast<Eigen::Index>(i);
    return sides.left[row].derivative[input] - sides.right[row].derivative[input];
  });
}

/// ‖∂g/∂ŷ_k‖ of the four vectors of an outcome. N is at least its twelve numbers.
template <class S, std::size_t N, class Law>
[[nodiscard]] std::array<S, 4> output_slopes(const Law& law, const Collision& collision,
                                             const Outcome<double>& outcome) {
  using T = Dual<S, N>;
  std::size_t next = 0;
  const auto sides = law(map_numbers<T>(collision, [](double x) { return T(static_cast<S>(x)); }),
                         map_outcome<T>(outcome, [&](double x) { return T::input(static_cast<S>(x), next++); }));
  std::array<S, 4> slopes{};
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    slopes[k] = root_of_squares(3, [&](std::size_t i) { return norm_of_derivative(sides, 3 * k + i); });
  }
  return slopes;
}

/// Σ_k ‖∂g/∂ŷ_k‖ (‖ŷ_k‖ + ‖y_k⁻‖). An output is its velocity before the impulse plus a change, and so is known to u
/// times the larger of both: its own size alone would allow nothing where the exact sum is zero.
template <class S>
[[nodiscard]] S part_by_outputs(const std::array<S, 4>& slopes, const ExactCase& exact_case,
                                const LiftedOutcome& outcome) {
  const std::array<double, 4> norms = outcome.norms();
  S part(0);
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    part += slopes[k] * static_cast<S>(norms[k] + exact_case.norms_before()[k]);
  }
  return part;
}

/// Σ_j ‖∂g/∂x_j‖ |x_j| over the numbers of the collision.
template <class S, class Law>
[[nodiscard]] S part_by_inputs(const Law& law, const DualInputs<S, collision_inputs>& inputs,
                               const Outcome<double>& outcome) {
  using T = Dual<S, collision_inputs>;
  const auto sides = law(inputs.collision, map_outcome<T>(outcome, [](double x) { return T(static_cast<S>(x)); }));
  S part(0);
  for (std::size_t j = 0; j < inputs.magnitude.size(); ++j) {
    part += norm_of_derivative(sides, j) * static_cast<S>(inputs.magnitude[j]);
  }
  return part;
}

inline constexpr double smallest_scale = 0x1p-900;
inline constexpr double largest_scale = 0x1p+1000;

/// Whether a scale can be multiplied by an allowance without leaving the range of binary64.
template <class S>
[[nodiscard]] bool is_in_range(S scale) {
  return scale >= static_cast<S>(smallest_scale) && scale <= static_cast<S>(largest_scale);
}

/// The part by outputs, in binary64. The slopes of a law that is affine in the outcome are the case's.
template <class Law>
[[nodiscard]] double part_by_outputs(const Law& law, const ExactCase& exact_case, const LiftedOutcome& outcome) {
  const Collision& collision = exact_case.collision();
  if (const std::optional<AffineLaw> name = law.name()) {
    return part_by_outputs(exact_case.slopes(*name, [&] { return slopes_of(law, collision); }), exact_case, outcome);
  }
  return part_by_outputs(output_slopes<double, outcome_inputs>(law, collision, outcome.rounded()), exact_case, outcome);
}

/// Both parts; none where the sum leaves the range of numbers.
template <class Law>
[[nodiscard]] std::optional<double> scale_of(const Law& law, const ExactCase& exact_case,
                                             const LiftedOutcome& outcome) {
  const double scale =
      part_by_inputs(law, exact_case.differentiated(), outcome.rounded()) + part_by_outputs(law, exact_case, outcome);
  if (is_in_range(scale)) {
    return scale;
  }
  // Products of extreme numbers leave the range of binary64; extended has the same bits and more range.
  using Wide = long double;
  const auto inputs = dual_inputs<Wide, collision_inputs>(exact_case.collision(), [](double x) { return Wide(x); });
  const Wide wide =
      part_by_inputs(law, inputs, outcome.rounded()) +
      part_by_outputs(output_slopes<Wide, collision_inputs>(law, exact_case.collision(), outcome.rounded()), exact_case,
                      outcome);
  return wide == 0 || is_in_range(wide) ? std::optional<double>(static_cast<double>(wide)) : std::nullopt;
}

/// A lower bound of the scale at a small part of its cost: of the two parts the one by outputs.
/// Precondition: collision and outcome are moderate.
template <class Law>
[[nodiscard]] double part_of_scale(const Law& law, const ExactCase& exact_case, const LiftedOutcome& outcome) {
  const double part = part_by_outputs(law, exact_case, outcome);
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
  return detail::output_slopes<double, outcome_inputs>(law, collision, unchanged(collision));
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
      scale = detail::scale_of(law, exact_case, outcome);
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
