// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/oracles/exact/definiteness.hpp>

namespace carom::oracles {

bool is_positive_definite(const Matrix3<Rational>& matrix) {
  const auto minors = principal_minors(matrix);
  return std::all_of(minors.begin(), minors.end(), [](const Rational& minor) { return minor > 0; });
}

bool is_positive_semidefinite(const Matrix3<Rational>& matrix) {
  const auto minors = principal_minors(matrix);
  return std::all_of(minors.begin(), minors.end(), [](const Rational& minor) { return minor >= 0; });
}

bool is_at_least(const Matrix3<Rational>& matrix, const Rational& bound) {
  return is_positive_semidefinite(less_multiple_of_identity<Rational>(matrix, bound));
}

bool is_at_most(const Matrix3<Rational>& matrix, const Rational& bound) {
  return is_at_least(Matrix3<Rational>(-matrix), Rational(-bound));
}

}  // namespace carom::oracles
