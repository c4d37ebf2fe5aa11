// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include <carom/oracles/exact/rational.hpp>

namespace carom::oracles {

/// A collision matrix as a subject shows it, and without rounding. For one thread.
class LiftedMatrix {
 public:
  /// Precondition: every number is finite.
  explicit LiftedMatrix(const Matrix3<long double>& reported) : reported_(reported) {}

  explicit LiftedMatrix(Matrix3<Rational> exact) : exact_(std::move(exact)) {}

  /// As it was reported; nullptr where it was given exactly.
  [[nodiscard]] const Matrix3<long double>* reported() const { return reported_ ? &*reported_ : nullptr; }

  [[nodiscard]] const Matrix3<Rational>& exact() const {
    if (!exact_) {
      exact_.emplace();
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          (*exact_)(i, j) = lift((*reported_)(i, j));
        }
      }
    }
    return *exact_;
  }

 private:
  std::optional<Matrix3<long double>> reported_;
  mutable std::optional<Matrix3<Rational>> exact_;
};

}  // namespace carom::oracles
