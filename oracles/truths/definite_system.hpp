// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>

namespace carom::oracles {

/// The solution of M x = b for a symmetric positive definite M = L D Lᵀ. The relative error is about u times the
/// condition number of M. Cramer's rule loses a higher power of this number (N. Higham, Accuracy and Stability of
/// Numerical Algorithms, §10.1 and §1.10.1).
template <class S>
class DefiniteSystem {
 public:
  explicit DefiniteSystem(const Matrix3<S>& m)
      : l10_(m(1, 0) / m(0, 0)), l20_(m(2, 0) / m(0, 0)), d0_(m(0, 0)), d1_(m(1, 1) - l10_ * m(1, 0)) {
    const S rest = m(2, 1) - l20_ * m(1, 0);
    l21_ = rest / d1_;
    d2_ = m(2, 2) - l20_ * m(2, 0) - l21_ * rest;
  }

  [[nodiscard]] Vector3<S> solve(const Vector3<S>& b) const {
    const S y1 = b[1] - l10_ * b[0];
    const S y2 = b[2] - l20_ * b[0] - l21_ * y1;
    const S x2 = y2 / d2_;
    const S x1 = y1 / d1_ - l21_ * x2;
    return {b[0] / d0_ - l10_ * x1 - l20_ * x2, x1, x2};
  }

 private:
  S l10_, l20_, l21_;  // L below its diagonal of ones
  S d0_, d1_, d2_;     // D
};

}  // namespace carom::oracles
