// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include <carom/oracles/exact/definiteness.hpp>

namespace carom::oracles {
namespace {

template <class T>
T minor2(const Matrix3<T>& m, int i, int j) {
  return m(i, i) * m(j, j) - m(j, i) * m(j, i);
}

template <class T>
T determinant(const Matrix3<T>& m) {
  return m(0, 0) * minor2(m, 1, 2) - m(1, 0) * (m(1, 0) * m(2, 2) - m(2, 1) * m(2, 0)) +
         m(2, 0) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
}

template <class T>
std::array<T, 7> principal_minors(const Matrix3<T>& m) {
  return {m(0, 0), m(1, 1), m(2, 2), minor2(m, 0, 1), minor2(m, 0, 2), minor2(m, 1, 2), determinant(m)};
}

template <class T>
std::optional<bool> is_positive_semidefinite_by_bounds(const Matrix3<T>& matrix) {
  bool decided = true;
  for (const T& minor : principal_minors(matrix)) {
    const std::optional<int> sign = minor.sign();
    if (sign == -1) {
      return false;
    }
    decided = decided && sign.has_value();
  }
  return decided ? std::optional<bool>(true) : std::nullopt;
}

template <class T>
Matrix3<T> shifted(const Matrix3<Rational>& matrix, const Rational& bound) {
  Matrix3<T> result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = T(matrix(i, j));
    }
  }
  return less_multiple_of_identity<T>(result, T(bound));
}

}  // namespace

bool is_positive_definite(const Matrix3<Rational>& matrix) {
  return matrix(0, 0) > 0 && minor2(matrix, 0, 1) > 0 && determinant(matrix) > 0;
}

bool is_positive_semidefinite(const Matrix3<Rational>& matrix) {
  const auto minors = principal_minors(matrix);
  return std::all_of(minors.begin(), minors.end(), [](const Rational& minor) { return minor >= 0; });
}

std::optional<bool> is_positive_semidefinite(const Matrix3<Enclosure>& matrix) {
  return is_positive_semidefinite_by_bounds(matrix);
}

std::optional<bool> is_positive_semidefinite(const Matrix3<Approximation>& matrix) {
  return is_positive_semidefinite_by_bounds(matrix);
}

bool is_at_least(const Matrix3<Rational>& matrix, const Rational& bound) {
  const std::optional<bool> decided = is_positive_semidefinite(shifted<Enclosure>(matrix, bound));
  return decided ? *decided : is_positive_semidefinite(shifted<Rational>(matrix, bound));
}

bool is_at_most(const Matrix3<Rational>& matrix, const Rational& bound) {
  return is_at_least(Matrix3<Rational>(-matrix), Rational(-bound));
}

}  // namespace carom::oracles
