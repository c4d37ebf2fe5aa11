// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/collision/solved_outcome.hpp>
#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/bounds/lazy.hpp>
#include <carom/oracles/bounds/moderate.hpp>
#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/exact/definiteness.hpp>
#include <carom/oracles/exact/rational.hpp>

namespace carom::oracles {

/// Whether xᵀ M x ≥ 0 for every x, or no value if the bounds do not decide it.
[[nodiscard]] inline std::optional<bool> is_positive_semidefinite(const Matrix3<Enclosure>& matrix) {
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

/// An outcome, reported by a subject or computed in ℚ, in the number types of the judge. For one thread.
class LiftedOutcome {
 public:
  /// If a number is not finite, only `is_moderate` may be called.
  explicit LiftedOutcome(const ReportedOutcome& reported)
      : LiftedOutcome(static_cast<const Outcome<long double>&>(reported)) {
    if (reported.collision_matrix) {
      collision_matrix_ = std::make_unique<LiftedMatrix>(*reported.collision_matrix);
    }
  }
  /// The same without a collision matrix.
  explicit LiftedOutcome(const Outcome<long double>& reported)
      : reported_(reported), is_moderate_(is_moderate(reported)) {}

  explicit LiftedOutcome(const SolvedOutcome<Rational>& exact)
      : rounded_(map_outcome<double>(exact, [](const Rational& x) { return to_double(x); })),
        further_(std::make_unique<Further>(
            Further{Lazy(map_outcome<Enclosure>(exact, [](const Rational& x) { return Enclosure(x); })),
                    Lazy<Outcome<Rational>>(static_cast<const Outcome<Rational>&>(exact))})) {
    if (exact.collision_matrix) {
      collision_matrix_ = std::make_unique<LiftedMatrix>(*exact.collision_matrix);
    }
  }

  /// This outcome with other velocities and the same collision matrix.
  [[nodiscard]] LiftedOutcome with_velocities(const Outcome<Rational>& exact) && {
    LiftedOutcome changed{SolvedOutcome<Rational>(exact)};
    changed.collision_matrix_ = std::move(collision_matrix_);
    return changed;
  }

  /// The outcome as the subject reported it; nullptr if it was computed in ℚ.
  [[nodiscard]] const Outcome<long double>* reported() const { return reported_ ? &*reported_ : nullptr; }

  /// The collision matrix that was reported with the outcome; nullptr if there was none.
  [[nodiscard]] const LiftedMatrix* collision_matrix() const { return collision_matrix_.get(); }

  /// Whether `reported` is not nullptr and no number in it exceeds `largest_moderate_outcome`, so that products stay in
  /// the range of binary64.
  [[nodiscard]] bool is_moderate() const { return is_moderate_; }

  [[nodiscard]] const Outcome<Enclosure>& enclosed() const {
    return further().enclosed.get(
        [this] { return map_outcome<Enclosure>(*reported_, [](long double x) { return Enclosure(x); }); });
  }
  [[nodiscard]] const Outcome<double>& rounded() const {
    return rounded_.get(
        [this] { return map_outcome<double>(*reported_, [](long double x) { return static_cast<double>(x); }); });
  }
  [[nodiscard]] const Outcome<Rational>& exact() const {
    return further().exact.get([this] { return lift(*reported_); });
  }

  /// Whether `rounded` equals the reported outcome. Precondition: `reported` is not nullptr.
  [[nodiscard]] bool is_exactly_rounded() const {
    CAROM_EXPECTS(reported_.has_value());
    bool is_exact = true;
    for (const OutcomeVector k : all_outcome_vectors) {
      is_exact = is_exact && *vectors(*reported_)[k] == vectors(rounded())[k]->template cast<long double>();
    }
    return is_exact;
  }

  /// The lengths of the four vectors, up to a few roundings.
  [[nodiscard]] const PerVector<double>& norms() const {
    return norms_.get([this] { return norms_of(rounded()); });
  }

 private:
  struct Further {
    Lazy<Outcome<Enclosure>> enclosed;
    Lazy<Outcome<Rational>> exact;
  };

  const Further& further() const {
    return *further_.get([] { return std::make_unique<Further>(); });
  }

  static bool is_moderate(const Outcome<long double>& reported) {
    return std::ranges::all_of(vectors(reported), [](const Vector3<long double>* part) {
      return (part->array().abs() <= largest_moderate_outcome).all();
    });
  }

  std::optional<Outcome<long double>> reported_;
  std::unique_ptr<LiftedMatrix> collision_matrix_;
  Lazy<Outcome<double>> rounded_;
  Lazy<PerVector<double>> norms_;
  bool is_moderate_ = false;
  Lazy<std::unique_ptr<Further>> further_;
};

}  // namespace carom::oracles
