// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/bounds/lazy.hpp>
#include <carom/oracles/bounds/moderate.hpp>
#include <carom/oracles/exact/rational.hpp>

namespace carom::oracles {

/// A collision matrix, reported by a subject or computed in ℚ, in several number types. For one thread.
class LiftedMatrix {
 public:
  explicit LiftedMatrix(const Matrix3<long double>& reported) : reported_(reported) {}

  explicit LiftedMatrix(Matrix3<Rational> exact) : exact_(std::move(exact)) {}

  /// The matrix as the subject reported it; nullptr if it was computed in ℚ.
  [[nodiscard]] const Matrix3<long double>* reported() const { return reported_ ? &*reported_ : nullptr; }

  /// Whether every number is finite. If not, only this function and `reported` may be called.
  [[nodiscard]] bool is_finite() const {
    return !reported_ || std::all_of(reported_->data(), reported_->data() + reported_->size(),
                                     [](long double x) { return std::isfinite(x); });
  }

  /// Whether `reported` is not nullptr and no number in it exceeds `largest_moderate_outcome`, so that products stay in
  /// the range of binary64.
  [[nodiscard]] bool is_moderate() const {
    return reported_ && reported_->cwiseAbs().maxCoeff() <= largest_moderate_outcome;
  }

  [[nodiscard]] const Matrix3<Rational>& exact() const {
    return exact_.get(
        [this]() -> Matrix3<Rational> { return reported_->unaryExpr([](long double x) { return lift(x); }); });
  }

  /// The matrix in numbers of type T: exact, or with error bounds, or rounded.
  template <class T>
  [[nodiscard]] Matrix3<T> in() const {
    if constexpr (std::is_same_v<T, Rational>) {
      return exact();
    } else {
      if (reported_) {
        return reported_->unaryExpr([](long double x) { return number<T>(x); });
      }
      return exact().unaryExpr([](const Rational& x) { return number<T>(x); });
    }
  }

 private:
  /// A dual number converts only from its own scalar type.
  template <class T>
  static T rounded(double x) {
    if constexpr (requires(T number) { number.value; }) {
      return T(static_cast<decltype(T::value)>(x));
    } else {
      return static_cast<T>(x);
    }
  }

  template <class T, class Number>
  static T number(const Number& x) {
    if constexpr (std::is_same_v<T, Enclosure>) {
      return Enclosure(x);
    } else if constexpr (std::is_same_v<Number, Rational>) {
      return rounded<T>(to_double(x));
    } else {
      return rounded<T>(static_cast<double>(x));
    }
  }

  std::optional<Matrix3<long double>> reported_;
  Lazy<Matrix3<Rational>> exact_;
};

}  // namespace carom::oracles
