// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <carom/oracles/filters/stage.hpp>
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/judge/norm_at_most.hpp>
#include <carom/properties/invariants/invariant.hpp>

/// How checks make and join verdicts.
namespace carom::properties {

[[nodiscard]] inline Verdict outside_domain(std::string why) { return {Status::skipped, std::move(why), 0, 0, {}, {}}; }

/// What cannot be decided is never a pass.
[[nodiscard]] inline Verdict beyond_range() {
  return {Status::skipped, "the scale leaves the range of numbers", 0, 0, {}, {}, true};
}

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
/// the vector; none is allowed where that leaves the range of numbers.
template <class Exact>
[[nodiscard]] Verdict vector_equals(const Vector3<oracles::Enclosure>& actual,
                                    const Vector3<oracles::Enclosure>& expected, const Exact& exact_pair,
                                    std::optional<double> allowed, bool filtered, std::string_view vector,
                                    const char* relation) {
  if (!allowed) {
    return beyond_range();
  }
  const auto violation = [&](const auto& left, const auto& right) {
    Verdict verdict{Status::violated,
                    fmt::format("{}, {}", vector, relation),
                    oracles::norm(oracles::difference(left, right)),
                    *allowed,
                    {},
                    {}};
    for (int i = 0; i < 3; ++i) {
      verdict.left.push_back(oracles::rounded(left[i]));
      verdict.right.push_back(oracles::rounded(right[i]));
    }
    return verdict;
  };
  const std::optional<bool> within =
      filtered ? oracles::norm_at_most(oracles::difference(actual, expected), *allowed) : std::nullopt;
  count(within ? oracles::Stage::enclosure : oracles::Stage::rational);
  if (within) {
    return *within ? Verdict{} : violation(actual, expected);
  }
  const auto& [exact_actual, exact_expected] = exact_pair();
  return oracles::norm_at_most(oracles::difference(exact_actual, exact_expected), *allowed)
             ? Verdict{}
             : violation(exact_actual, exact_expected);
}

/// Whether these vectors of two outcomes surely differ by no more than `allowance` times `scale`, by numbers as they
/// are reported: x87 extended, or what long double is elsewhere. A component of `left` may be y, ±y, a product of y, or
/// y + (to − from) with ‖to‖ + ‖from‖ at most the scale, rounded at each operation. By u of it, then, it is off itself,
/// and by u of the term that was added to y, whose components add up to √3 times the scale at most; each difference is
/// off by u of it, and their sum, the product and the sum that are compared by four times that.
[[nodiscard]] inline bool surely_near(const ReportedOutcome& left, const ReportedOutcome& right, double allowance,
                                      const PerVector<double>& scale,
                                      std::span<const OutcomeVector> which = all_outcome_vectors) {
  static_assert(std::numeric_limits<long double>::is_iec559);
  constexpr long double two_u = std::numeric_limits<long double>::epsilon();
  const auto x = vectors(left);
  const auto y = vectors(right);
  return std::all_of(which.begin(), which.end(), [&](OutcomeVector k) {
    long double missed = 0;
    long double size = scale[k];
    for (int i = 0; i < 3; ++i) {
      missed += std::abs((*x[k])[i] - (*y[k])[i]);
      size += std::abs((*x[k])[i]);
    }
    return missed * (1 + 4 * two_u) + two_u * size <= allowance * scale[k];
  });
}

/// Whether bounds show that these vectors of an outcome are as before the impulse, each to within the allowance times
/// its own size: less than any law allows, and surely a finite number.
[[nodiscard]] inline bool is_surely_untouched(const oracles::ExactCase& exact_case,
                                              const oracles::LiftedOutcome& outcome,
                                              const oracles::Yardstick& yardstick,
                                              std::span<const OutcomeVector> which = all_outcome_vectors) {
  if (!yardstick.uses_bounds() || !exact_case.bounds().is_moderate() || !outcome.is_moderate()) {
    return false;
  }
  const auto before =
      map_outcome<long double>(unchanged(exact_case.collision()), [](double x) { return static_cast<long double>(x); });
  const bool is_untouched =
      surely_near(before, *outcome.reported(), yardstick.allowance(), exact_case.bounds().norms_before(), which);
  if (is_untouched) {
    count(oracles::Stage::approximation);
  }
  return is_untouched;
}

/// Both must hold: the worse of two verdicts, a violation before what could not be decided, that before a pass, and a
/// pass before what is outside the domain, which leaves it to the other.
[[nodiscard]] inline Verdict both(Verdict first, Verdict second) {
  const auto rank = [](const Verdict& verdict) {
    switch (verdict.status) {
      case Status::violated:
        return 3;
      case Status::holds:
        return 1;
      case Status::skipped:
        break;
    }
    return verdict.is_undecided ? 2 : 0;
  };
  const int lead = rank(second) - rank(first);
  const bool is_second = lead > 0 || (lead == 0 && second.severity() > first.severity());
  return is_second ? std::move(second) : std::move(first);
}

}  // namespace carom::properties
