// SPDX-License-Identifier: BSL-1.0
#include <array>

#include <carom/collision/expects.hpp>
#include <carom/oracles/exact/polynomial.hpp>
#include <carom/oracles/models/coulomb.hpp>
#include <carom/oracles/models/models.hpp>

namespace carom::oracles {
namespace {

/// Bits to which a slip resistance is isolated.
constexpr int bits_of_resistance = 120;

/// The linear system of one collision.
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

  /// n(ν) = adj M(ν) b, component by component.
  [[nodiscard]] std::array<Polynomial, 3> numerators() const {
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
    return {quadratic_through(zero[0], one[0], minus_one[0]), quadratic_through(zero[1], one[1], minus_one[1]),
            quadratic_through(zero[2], one[2], minus_one[2])};
  }
};

Truth<Rational> truth_by(const BasicCollision<Rational>& c, const Vector3<Rational>& impulse) {
  return {impulse, sum(unchanged(c), response<Rational>(c, impulse))};
}

/// Whether the polynomial is positive at the root, where it is not zero.
bool is_positive_at(const Polynomial& polynomial, const PositiveRoots& roots, Interval root) {
  if (polynomial.degree() < 0) {
    return false;
  }
  const PositiveRoots of_polynomial(polynomial);
  for (int bits = 8; of_polynomial.count_in(root) > 0; bits *= 2) {
    root = roots.refined(root, bits);
  }
  return polynomial(root.high) > 0;
}

}  // namespace

std::vector<CoulombAnswer> coulomb_answers(const BasicCollision<Rational>& c) {
  CAROM_EXPECTS(has_movable_body(c) && normal_velocity_before(c) < 0, normal_velocity_before(c));
  if (c.friction == 0) {
    Truth<Rational> truth = colliding_truth(c, Model::frictionless, Branch::only);
    return {{AnswerKind::frictionless, std::move(truth)}};
  }
  const Slip slip(c);
  std::vector<CoulombAnswer> answers;
  const Vector3<Rational> sticking = slip.impulse(Rational(0));
  const Sides<Rational, 1> cone = squared_cone(c, sticking);
  if (c.normal.dot(sticking) >= 0 && cone.left[0] <= cone.right[0]) {
    answers.push_back({AnswerKind::sticks, truth_by(c, sticking)});
  }
  const std::array<Polynomial, 3> n = slip.numerators();
  const auto times = [](const Rational& factor, const Polynomial& of) { return Polynomial({factor}) * of; };
  const Polynomial along = times(c.normal[0], n[0]) + times(c.normal[1], n[1]) + times(c.normal[2], n[2]);
  Polynomial surface = times(-c.friction * c.friction, along * along);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Polynomial component =
        times(c.normal[static_cast<int>(j)], n[k]) - times(c.normal[static_cast<int>(k)], n[j]);
    surface = surface + component * component;
  }
  const PositiveRoots roots(surface);
  for (const Interval& root : roots.intervals()) {
    if (is_positive_at(along, roots, root)) {
      answers.push_back({AnswerKind::slips, truth_by(c, slip.impulse(roots.refined(root, bits_of_resistance).high))});
    }
  }
  return answers;
}

}  // namespace carom::oracles
