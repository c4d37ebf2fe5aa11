// SPDX-License-Identifier: BSL-1.0
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

namespace carom::properties {

[[nodiscard]] inline Verdict outside_domain(std::string why) {
  return {.status = Status::skipped, .detail = std::move(why)};
}

/// An undecided check is never a pass.
[[nodiscard]] inline Verdict beyond_range() {
  return {.status = Status::skipped, .detail = "the scale overflows or underflows", .is_undecided = true};
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

/// Whether some permitted inputs collide, others separate, and the two answers are far apart
/// (`ExactCase::has_two_answers`). If so, an outcome near either answer is permitted, so an invariant that expects one
/// of them does not apply.
[[nodiscard]] inline bool has_two_answers(const Evidence& e, const oracles::ExactCase& exact_case) {
  return determines_outcome(e.law) && exact_case.has_two_answers(e.law, e.allowance());
}
[[nodiscard]] inline Verdict between_two_answers() {
  return outside_domain(
      "the contact differs from colliding and from separating contacts by rounding only, and their answers differ");
}

/// Whether the distance of two enclosed vectors, `actual` and `expected`, is at most `allowed`. If the enclosures do
/// not decide, `exact_pair()` gives both vectors exactly. `vector` and `relation` name the compared vectors. If
/// `allowed` has no value, the verdict is undecided.
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

/// The bound of `surely_near`. A test counts its roundings with another scalar type S.
namespace nearness {

/// 2u, with the unit roundoff u of long double, the type of reported numbers.
inline constexpr long double two_u = std::numeric_limits<long double>::epsilon();
static_assert(std::numeric_limits<long double>::is_iec559);

/// 1 + 8u, for five roundings of a term of M: one of the difference, two of the sum, two of the bound.
inline constexpr long double up = 1 + 4 * two_u;

/// D = M (1 + 8u) + 2u (s + ‖x‖₁). M is the computed ‖x − y‖₁, and s is `scale`.
template <class S>
[[nodiscard]] S distance_above(const Vector3<S>& x, const Vector3<S>& y, const S& scale) {
  using std::abs;
  S missed(0);
  S size = scale;
  for (int i = 0; i < 3; ++i) {
    missed += abs(S(x[i] - y[i]));
    size += abs(x[i]);
  }
  return missed * S(up) + S(two_u) * size;
}

}  // namespace nearness

/// Whether these vectors of `left` and `right` certainly agree. Let x be a vector of `left`, y that of `right`, and s
/// its `scale`. x is computed from a vector z of a reported outcome, and x* is the exact result. If true, ‖x* − y‖₂ ≤
/// `allowance` · s. If false, this may still hold. Proof:
///
///   (1) If x is z, −z or a multiple of z, ‖x − x*‖₁ ≤ u ‖x‖₁.
///   (2) If x = z + (to − from) and ‖to‖ + ‖from‖ ≤ (1 + 2⁻⁵⁰) s, ‖x − x*‖₁ ≤ u ‖x‖₁ + √3 (1 + 2⁻⁵⁰) (1 + u) u s.
///   (3) In both cases, ‖x* − y‖₂ ≤ ‖x − y‖₁ + ‖x − x*‖₁.
///   (4) The right side of (3) is at most the D of `nearness::distance_above`.
///   (5) The function shows D ≤ `allowance` · s. This product is rounded as in the exact judge.
[[nodiscard]] inline bool surely_near(const ReportedOutcome& left, const ReportedOutcome& right, double allowance,
                                      const PerVector<double>& scale,
                                      std::span<const OutcomeVector> which = all_outcome_vectors) {
  const auto x = vectors(left);
  const auto y = vectors(right);
  return std::all_of(which.begin(), which.end(), [&](OutcomeVector k) {
    return nearness::distance_above<long double>(*x[k], *y[k], scale[k]) <= allowance * scale[k];
  });
}

/// Whether bounds show that these vectors of an outcome are unchanged, each within the allowance times its length.
/// Every law permits at least this difference.
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

/// The worse of two verdicts that must both hold. The order from the worst is: violated, undecided, holds, outside the
/// domain. So a verdict outside the domain leaves the decision to the other.
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
