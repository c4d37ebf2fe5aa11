// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Cholesky>

#include <carom/collision/expects.hpp>
#include <carom/impulse/numbers/products.hpp>
#include <carom/impulse/select.hpp>

/// Ways to solve M x = b for a symmetric positive definite 3×3 matrix M. Each struct is an argument for the template
/// parameter `Solve` of a law. `least` is a lower bound of the eigenvalues of M. Only Ldlt uses it.
namespace carom::impulse {

/// M = L D Lᵀ. The decomposition needs no square root and no branch, so it runs in any field and in SIMD packs. Each
/// exact pivot is a diagonal entry of a Schur complement of M, and therefore at least the least eigenvalue of M.
/// `least` replaces each smaller computed pivot, so nothing is divided by zero. The exact x has |x_i| ≤ ‖x‖ ≤ ‖b‖ /
/// least ≤ √3 max |b_i| / least. If a computed component exceeds 2 max |b_i| / least, all of x is scaled down, so that
/// M x stays along b.
struct Ldlt {
  template <class S>
  [[nodiscard]] static Vector3<S> solve(const Matrix3<S>& m, const Vector3<S>& b) {
    const auto as_computed = [](const S& computed) { return computed; };
    return solve_by<S>(m, b, as_computed, as_computed);
  }
  /// Precondition: least > 0.
  template <class S>
  [[nodiscard]] static Vector3<S> solve(const Matrix3<S>& m, const Vector3<S>& b, const S& least) {
    CAROM_EXPECTS(least > S(0), least);
    const S largest = greatest_size(b);
    const S bound = (largest + largest) / least;
    const Vector3<S> x = solve_by<S>(
        m, b, [&](const S& computed) { return at_least(least, computed); },
        [&](const S& computed) { return at_least(S(-bound), S(-at_least(S(-bound), S(-computed)))); });
    const S size = greatest_size(x);
    if (none_of(bound < size)) {
      return x;
    }
    return x * S(bound / at_least(bound, size));
  }

 private:
  template <class S, class Pivot, class Bounded>
  [[nodiscard]] static Vector3<S> solve_by(const Matrix3<S>& m, const Vector3<S>& b, const Pivot& pivot,
                                           const Bounded& bounded) {
    const S d0 = pivot(m(0, 0));
    const S l10 = m(1, 0) / d0;
    const S l20 = m(2, 0) / d0;
    const S d1 = pivot(m(1, 1) - l10 * m(1, 0));
    const S e21 = m(2, 1) - l20 * m(1, 0);
    const S l21 = e21 / d1;
    const S d2 = pivot((m(2, 2) - l20 * m(2, 0)) - l21 * e21);
    const S y1 = b[1] - l10 * b[0];
    const S y2 = (b[2] - l20 * b[0]) - l21 * y1;
    const S x2 = bounded(y2 / d2);
    const S x1 = y1 / d1 - l21 * x2;
    const S x0 = (b[0] / d0 - l10 * x1) - l20 * x2;
    return {x0, x1, x2};
  }
};

/// Eigen's Cholesky decomposition M = L Lᵀ.
struct EigenLlt {
  template <class S>
  [[nodiscard]] static Vector3<S> solve(const Matrix3<S>& m, const Vector3<S>& b, const S& = S(0)) {
    return m.llt().solve(b);
  }
};

/// Eigen's M = Pᵀ L D Lᵀ P, with pivots chosen by size.
struct EigenLdlt {
  template <class S>
  [[nodiscard]] static Vector3<S> solve(const Matrix3<S>& m, const Vector3<S>& b, const S& = S(0)) {
    return m.ldlt().solve(b);
  }
};

/// M⁻¹ = adj(M) / det(M).
struct Adjugate {
  template <class S>
  [[nodiscard]] static Vector3<S> solve(const Matrix3<S>& m, const Vector3<S>& b, const S& = S(0)) {
    const auto minor = [&](int i, int j, int k, int l) -> S { return m(i, j) * m(k, l) - m(i, l) * m(k, j); };
    Matrix3<S> adjugate;
    adjugate << minor(1, 1, 2, 2), minor(2, 1, 0, 2), minor(0, 1, 1, 2),  //
        minor(1, 2, 2, 0), minor(2, 2, 0, 0), minor(0, 2, 1, 0),          //
        minor(1, 0, 2, 1), minor(2, 0, 0, 1), minor(0, 0, 1, 1);
    const S determinant = (m(0, 0) * adjugate(0, 0) + m(0, 1) * adjugate(1, 0)) + m(0, 2) * adjugate(2, 0);
    return times(adjugate, b) / determinant;
  }
};

}  // namespace carom::impulse
