// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/laws/truth.hpp>

namespace carom::oracles {

enum class AnswerKind {
  untouched,     // no impulse acts
  sticks,        // N × V⁺ = 0
  frictionless,  // μ = 0: it slips or sticks
  slips,         // F lies on the surface of the cone, against the slip
};

[[nodiscard]] constexpr const char* name_of(AnswerKind kind) {
  constexpr std::array names{"untouched", "sticks", "frictionless", "slips"};
  return names[static_cast<std::size_t>(kind)];
}

struct CoulombAnswer {
  AnswerKind kind;
  Truth<Rational> truth;  // exact for each kind except `slips`, which has a slip resistance within 2⁻¹²⁰ of the exact
                          // one

  [[nodiscard]] bool is_exact() const { return kind != AnswerKind::slips; }
};

/// A bound of the effect of friction on its own limit. Let K be the collision matrix, with K_NN along the unit normal,
/// K_TN across it, c = K_TN / K_NN, and S = K_TT − K_NN c cᵀ with eigenvalues from `least` to `greatest`. `coupling` is
/// ‖c‖.
///
/// F_T minimises ½ F_T·S F_T + a·F_T over the disc ‖F_T‖ ≤ ρ. If ρ changes by δρ, F_T changes by at most
/// δρ · greatest / least. The limit is ρ = μ F_n with F_n = b − c·F_T. So if F_T changes by δ, it causes itself to
/// change by at most δ times the result. If the result is below 1, the law has one answer (S. Banach's fixed-point
/// theorem).
template <class S>
[[nodiscard]] S friction_feedback(const S& friction, const S& coupling, const S& least, const S& greatest) {
  return friction * coupling * greatest / least;
}

/// All answers of the law `coulomb` to a contact that collides. An answer is an impulse F with
///
///   N·V⁺ = −ε N·V⁻,   ‖N × F‖ ≤ μ N·F,   and either N × V⁺ = 0, or ‖N × F‖ = μ N·F and ν F_T = −V_T⁺ with ν > 0.
///
/// F_T and V_T⁺ are the parts of F and V⁺ perpendicular to N, and ν is the slip resistance. Let P be the projection
/// onto the plane perpendicular to N, and b = −(V⁻ + ε (N·V⁻)/(N·N) N). Then (K + ν P) F = b. ν = 0 is sticking, and
/// ν > 0 is slip. By Cramer's rule, F = n(ν) / det(K + ν P), with n quadratic in ν and the determinant positive. So the
/// answers that slip are the roots ν > 0 of the quartic ‖N × n‖² − (μ N·n)² with N·n > 0. There is at least one answer
/// (docs/guide/laws.md). Preconditions: the contact collides; a body is movable.
[[nodiscard]] std::vector<CoulombAnswer> coulomb_answers(const BasicCollision<Rational>& collision);

}  // namespace carom::oracles
