// SPDX-License-Identifier: BSL-1.0
#include <array>

#include <carom/collision/expects.hpp>
#include <carom/oracles/exact/roots.hpp>
#include <carom/oracles/truths/coulomb.hpp>
#include <carom/oracles/truths/models.hpp>

namespace carom::oracles {
namespace {

/// The bits of precision of a slip resistance ν (coulomb.hpp).
constexpr int bits_of_resistance = 120;

/// The linear system (K + ν P) F = b of one collision (coulomb.hpp).
struct Slip {
  Matrix3<Rational> response;  // K
  Matrix3<Rational> across;    // P
  Vector3<Rational> change;    // b

  explicit Slip(const BasicCollision<Rational>& c) : response(response_matrix(c)), change(wanted_change<Sticking>(c)) {
    const Vector3<Rational>& n = c.normal;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        across(i, j) = Rational(i == j ? 1 : 0) - n[i] * n[j] / n.dot(n);
      }
    }
  }

  [[nodiscard]] Matrix3<Rational> matrix(const Rational& resistance) const { return response + across * resistance; }
  [[nodiscard]] Vector3<Rational> impulse(const Rational& resistance) const {
    return cramer<Rational>(matrix(resistance), change);
  }

  /// The coefficients of ν⁰, ν¹ and ν² in n(ν) = adj(K + ν P) b, from n(0), n(1) and n(−1).
  [[nodiscard]] std::array<Vector3<Rational>, 3> numerator() const {
    const auto at = [&](int resistance) -> Vector3<Rational> {
      const Matrix3<Rational> m = matrix(Rational(resistance));
      const Vector3<Rational> c0 = m.col(0);
      const Vector3<Rational> c1 = m.col(1);
      const Vector3<Rational> c2 = m.col(2);
      return {change.dot(c1.cross(c2)), change.dot(c2.cross(c0)), change.dot(c0.cross(c1))};
    };
    const Vector3<Rational> zero = at(0);
    const Vector3<Rational> one = at(1);
    const Vector3<Rational> minus_one = at(-1);
    const Rational half(1, 2);
    return {zero, half * (one - minus_one), half * (one + minus_one) - zero};
  }
};

Truth<Rational> truth_by(const BasicCollision<Rational>& c, const Vector3<Rational>& impulse) {
  return {impulse, sum(unchanged(c), response<Rational>(c, impulse))};
}

}  // namespace

std::vector<CoulombAnswer> coulomb_answers(const BasicCollision<Rational>& c) {
  CAROM_EXPECTS(has_movable_body(c) && normal_velocity_before(c) < 0, normal_velocity_before(c));
  if (c.friction == 0) {
    Truth<Rational> truth = colliding_truth(c, Law::frictionless, Branch::only);
    return {{AnswerKind::frictionless, std::move(truth)}};
  }
  const Slip slip(c);
  std::vector<CoulombAnswer> answers;
  const Vector3<Rational> sticking = slip.impulse(Rational(0));
  const Sides<Rational, 1> cone = squared_cone(c, sticking);
  if (c.normal.dot(sticking) >= 0 && cone.left[0] <= cone.right[0]) {
    answers.push_back({AnswerKind::sticks, truth_by(c, sticking)});
  }
  // `along` is N·n(ν), and `surface` is ‖N × n(ν)‖² − (μ N·n(ν))².
  const std::array<Vector3<Rational>, 3> n = slip.numerator();
  Coefficients along;
  for (const Vector3<Rational>& of : n) {
    along.push_back(c.normal.dot(of));
  }
  Coefficients surface(5);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      surface[i + j] += c.normal.cross(n[i]).dot(c.normal.cross(n[j])) - c.friction * c.friction * along[i] * along[j];
    }
  }
  for (const Rational& resistance : positive_roots(surface, along, bits_of_resistance)) {
    answers.push_back({AnswerKind::slips, truth_by(c, slip.impulse(resistance))});
  }
  return answers;
}

}  // namespace carom::oracles
