// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <carom/oracles/stage.hpp>
#include <carom/properties/invariant.hpp>

/// How checks make and join verdicts.
namespace carom::properties {

[[nodiscard]] inline Verdict outside_domain(std::string why) { return {Status::skipped, std::move(why), 0, 0, {}, {}}; }

/// What cannot be decided is never a pass.
[[nodiscard]] inline Verdict beyond_range() { return outside_domain("the scale leaves the range of numbers"); }

[[nodiscard]] inline Verdict verdict_of(oracles::Comparison comparison, std::string what) {
  if (!comparison.is_decided) {
    return beyond_range();
  }
  if (comparison.holds) {
    return {};
  }
  return {Status::violated,           std::move(what),
          comparison.residual,        comparison.allowed,
          std::move(comparison.left), std::move(comparison.right)};
}

/// A vector of an outcome that should be `expected`, and is allowed to miss it by so much. Both are given as
/// enclosures, and as functions that give them exactly where those do not decide. `relation` says what is compared of
/// the vector.
template <class Exact>
[[nodiscard]] Verdict vector_equals(const Vector3<oracles::Enclosure>& actual,
                                    const Vector3<oracles::Enclosure>& expected, const Exact& exact_pair,
                                    double allowed, bool filtered, std::string_view vector, const char* relation) {
  if (!std::isfinite(allowed)) {
    return beyond_range();
  }
  const auto violation = [&](const auto& left, const auto& right) {
    Verdict verdict{Status::violated,
                    fmt::format("{}, {}", vector, relation),
                    oracles::norm(oracles::difference(left, right)),
                    allowed,
                    {},
                    {}};
    for (int i = 0; i < 3; ++i) {
      verdict.left.push_back(oracles::rounded(left[i]));
      verdict.right.push_back(oracles::rounded(right[i]));
    }
    return verdict;
  };
  const std::optional<bool> within =
      filtered ? oracles::norm_at_most(oracles::difference(actual, expected), allowed) : std::nullopt;
  count(within ? oracles::Stage::enclosure : oracles::Stage::rational);
  if (within) {
    return *within ? Verdict{} : violation(actual, expected);
  }
  const auto& [exact_actual, exact_expected] = exact_pair();
  return oracles::norm_at_most(oracles::difference(exact_actual, exact_expected), allowed)
             ? Verdict{}
             : violation(exact_actual, exact_expected);
}

/// Approximations of outcomes in binary64 decide by how much these differ down to here.
inline constexpr double least_allowance_for_differences = 0x1p-50;

/// Whether bounds show that these vectors of two outcomes differ by no more than `allowance` times `scale`.
template <class T>
[[nodiscard]] bool surely_near(const Outcome<T>& left, const Outcome<T>& right, double allowance,
                               const std::array<double, 4>& scale,
                               std::initializer_list<std::size_t> which = {0, 1, 2, 3}) {
  const auto x = vectors(left);
  const auto y = vectors(right);
  return std::all_of(which.begin(), which.end(), [&](std::size_t k) {
    return oracles::norm_at_most(oracles::difference(*x[k], *y[k]), allowance * scale[k]).value_or(false);
  });
}

/// Whether bounds show that these vectors of an outcome are as before the impulse, each to within the allowance times
/// its own size: less than any law allows, and surely a finite number.
[[nodiscard]] inline bool is_surely_untouched(const oracles::ExactCase& exact_case,
                                              const oracles::LiftedOutcome& outcome,
                                              const oracles::Yardstick& yardstick,
                                              std::initializer_list<std::size_t> which) {
  const double allowance = yardstick.allowance();
  if (!yardstick.uses_bounds() || !exact_case.is_moderate() || !outcome.is_moderate()) {
    return false;
  }
  const std::array<double, 4>& below = exact_case.norms_before();
  const bool by_approximations = allowance >= least_allowance_for_differences;
  const bool is_untouched =
      by_approximations
          ? surely_near(outcome.approximate(), unchanged(exact_case.approximate()), allowance, below, which)
          : surely_near(outcome.enclosed(), unchanged(exact_case.enclosed()), allowance, below, which);
  if (is_untouched) {
    count(by_approximations ? oracles::Stage::approximation : oracles::Stage::enclosure);
  }
  return is_untouched;
}

/// Both must hold: the worse of two verdicts, a violation before a pass before a skip.
[[nodiscard]] inline Verdict both(const Verdict& first, const Verdict& second) {
  const auto rank = [](const Verdict& verdict) {
    return verdict.status == Status::violated ? 2 : (verdict.status == Status::holds ? 1 : 0);
  };
  if (rank(first) != rank(second)) {
    return rank(first) > rank(second) ? first : second;
  }
  return second.severity() > first.severity() ? second : first;
}

}  // namespace carom::properties
