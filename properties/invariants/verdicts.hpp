// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <carom/oracles/bounds/stage.hpp>
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/judge/norm_at_most.hpp>
#include <carom/properties/invariants/invariant.hpp>

namespace carom::properties {

[[nodiscard]] inline Verdict does_not_apply(std::string why) {
  return {.status = Status::skipped, .detail = std::move(why)};
}

/// An undecided check is never a pass.
[[nodiscard]] inline Verdict beyond_range() {
  return {.status = Status::skipped, .detail = "the scale overflows or underflows", .is_undecided = true};
}

[[nodiscard]] inline Verdict verdict_of(oracles::EquationCheck comparison, std::string what) {
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

/// A number rounded for print. Zero if its bounds do not tell it from zero.
[[nodiscard]] inline double rounded_for_print(const oracles::Enclosure& x) {
  return x.sign().has_value() ? oracles::rounded(x) : 0;
}
template <class T>
[[nodiscard]] double rounded_for_print(const T& exact) {
  return oracles::rounded(exact);
}

/// Whether some permitted inputs collide, others separate, and the two answers are far apart
/// (`ExactCase::has_two_answers`). If so, an outcome near either answer is permitted, so an invariant that expects one
/// of them does not apply.
[[nodiscard]] inline bool has_two_answers(const Evidence& e, const oracles::ExactCase& exact_case) {
  return determines_outcome(e.law) && exact_case.has_two_answers(e.law, e.allowance());
}
[[nodiscard]] inline Verdict between_two_answers() {
  return does_not_apply(
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

/// Whether enclosures show that these vectors of `left` and `right` agree: the distance of each pair is at most
/// `allowance` times its `scale`. Precondition: these products are finite.
[[nodiscard]] inline bool surely_near(const Outcome<oracles::Enclosure>& left, const Outcome<oracles::Enclosure>& right,
                                      double allowance, const PerVector<double>& scale,
                                      std::span<const OutcomeVector> which = all_outcome_vectors) {
  const auto x = vectors(left);
  const auto y = vectors(right);
  const bool near = std::ranges::all_of(which, [&](OutcomeVector k) {
    return oracles::norm_at_most(oracles::difference(*x[k], *y[k]), allowance * scale[k]).value_or(false);
  });
  if (near) {
    count(oracles::Stage::enclosure);
  }
  return near;
}

/// Whether bounds show that these vectors of an outcome are unchanged, each within the allowance times its length.
/// Every law permits at least this difference.
[[nodiscard]] inline bool is_surely_untouched(const oracles::ExactCase& exact_case,
                                              const oracles::LiftedOutcome& outcome,
                                              const oracles::Yardstick& yardstick,
                                              std::span<const OutcomeVector> which = all_outcome_vectors) {
  return yardstick.uses_bounds() && exact_case.is_moderate() && outcome.is_moderate() &&
         surely_near(unchanged(exact_case.enclosed()), outcome.enclosed(), yardstick.allowance(),
                     exact_case.norms_before(), which);
}

/// The worse of two verdicts that must both hold. The order from the worst is: violated, undecided, holds, does not
/// apply. So a verdict that does not apply leaves the decision to the other.
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

/// Compares one vector of the outcome with the vector before the impulse. The permitted difference is the allowance
/// times the law's sensitivity.
[[nodiscard]] inline Verdict vector_untouched(const Evidence& e, OutcomeVector k,
                                              const oracles::Sensitivity& sensitivity) {
  const auto before = unchanged(e.exact_case.enclosed());
  const auto exact_pair = [&] {
    const auto exactly_before = unchanged(e.exact_case.exact());
    return std::pair{*vectors(e.outcome.exact())[k], *vectors(exactly_before)[k]};
  };
  return vector_equals(*vectors(e.outcome.enclosed())[k], *vectors(before)[k], exact_pair,
                       e.yardstick.allowed(sensitivity[k]), e.yardstick.filtered(), name_of(k), "after and before");
}

}  // namespace carom::properties
