// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/laws/truth.hpp>

namespace carom::oracles {

/// How an answer of the law `coulomb` ends.
enum class AnswerKind {
  untouched,     // no impulse acts
  sticks,        // N × V⁺ = 0
  frictionless,  // μ = 0: slips or not
  slips,         // on the surface of the cone, against the slip
};

[[nodiscard]] constexpr const char* name_of(AnswerKind kind) {
  switch (kind) {
    case AnswerKind::sticks:
      return "sticks";
    case AnswerKind::frictionless:
      return "frictionless";
    case AnswerKind::slips:
      return "slips";
    case AnswerKind::untouched:
      break;
  }
  return "untouched";
}

/// An answer of the law `coulomb`, which may have several to one collision.
struct CoulombAnswer {
  AnswerKind kind;
  Truth<Rational> truth;  // exact unless it slips: then of a slip resistance within 2⁻¹²⁰ of the exact one

  [[nodiscard]] bool is_exact() const { return kind != AnswerKind::slips; }
};

/// All answers of the law `coulomb` to a contact that collides:
///
///   N·V⁺ = −ε N·V⁻,   ‖N × F‖ ≤ μ N·F,   and N × V⁺ = 0, or ‖N × F‖ = μ N·F and ν F_T = −V_T⁺ with ν > 0.
///
/// With M(ν) = K + ν P, P the projection across N, F = M(ν)⁻¹ b for b = −(V⁻ + ε (N·V⁻)/(N·N) N): sticking at ν = 0.
/// By Cramer's rule F = n(ν) / det M(ν), n quadratic and the determinant positive, so that the answers that slip are
/// the positive roots of the quartic ‖N × n‖² − (μ N·n)² with N·n > 0: isolated, and so counted, exactly. There is at
/// least one answer: where F(0) is not in the cone, F(ν) is on its surface on the way to the frictionless F(∞), which
/// is. Precondition: the contact collides.
[[nodiscard]] std::vector<CoulombAnswer> coulomb_answers(const BasicCollision<Rational>& collision);

}  // namespace carom::oracles
