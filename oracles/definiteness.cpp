// SPDX-License-Identifier: GPL-3.0-or-later
#include <carom/oracles/definiteness.hpp>

namespace carom::oracles {
namespace {

Rational minor2(const Matrix3<Rational>& m, int i, int j) { return m(i, i) * m(j, j) - m(j, i) * m(j, i); }

Rational determinant(const Matrix3<Rational>& m) {
  return m(0, 0) * minor2(m, 1, 2) - m(1, 0) * (m(1, 0) * m(2, 2) - m(2, 1) * m(2, 0)) +
         m(2, 0) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
}

}  // namespace

bool is_positive_definite(const Matrix3<Rational>& matrix) {
  return matrix(0, 0) > 0 && minor2(matrix, 0, 1) > 0 && determinant(matrix) > 0;
}

bool is_positive_semidefinite(const Matrix3<Rational>& matrix) {
  for (int i = 0; i < 3; ++i) {
    if (matrix(i, i) < 0) {
      return false;
    }
  }
  return minor2(matrix, 0, 1) >= 0 && minor2(matrix, 0, 2) >= 0 && minor2(matrix, 1, 2) >= 0 &&
         determinant(matrix) >= 0;
}

bool is_at_least(const Matrix3<Rational>& matrix, const Rational& bound) {
  Matrix3<Rational> shifted = matrix;
  for (int i = 0; i < 3; ++i) {
    shifted(i, i) -= bound;
  }
  return is_positive_semidefinite(shifted);
}

bool is_at_most(const Matrix3<Rational>& matrix, const Rational& bound) {
  return is_at_least(Matrix3<Rational>(-matrix), Rational(-bound));
}

}  // namespace carom::oracles
