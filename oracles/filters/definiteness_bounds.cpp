// SPDX-License-Identifier: BSL-1.0
#include <carom/oracles/filters/definiteness_bounds.hpp>

namespace carom::oracles {
std::optional<bool> is_positive_semidefinite(const Matrix3<Enclosure>& matrix) {
  bool decided = true;
  for (const Enclosure& minor : principal_minors(matrix)) {
    const std::optional<int> sign = minor.sign();
    if (sign == -1) {
      return false;
    }
    decided = decided && sign.has_value();
  }
  return decided ? std::optional<bool>(true) : std::nullopt;
}

bool is_at_least_by_enclosures(const Matrix3<Rational>& matrix, const Rational& bound) {
  const Matrix3<Enclosure> enclosed = matrix.unaryExpr([](const Rational& x) { return Enclosure(x); });
  const std::optional<bool> decided =
      is_positive_semidefinite(less_multiple_of_identity<Enclosure>(enclosed, Enclosure(bound)));
  return decided ? *decided : is_at_least(matrix, bound);
}

bool is_at_most_by_enclosures(const Matrix3<Rational>& matrix, const Rational& bound) {
  return is_at_least_by_enclosures(Matrix3<Rational>(-matrix), Rational(-bound));
}

}  // namespace carom::oracles
