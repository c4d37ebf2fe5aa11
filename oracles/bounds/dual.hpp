// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include <carom/collision/expects.hpp>
#include <carom/oracles/laws/eigen_scalar.hpp>
#include <carom/oracles/laws/fraction.hpp>

namespace carom::oracles {

/// A number and its first derivatives with respect to N inputs (forward differentiation). The derivatives are exact,
/// except for the rounding of the field S.
template <class S, std::size_t N>
struct Dual {
  S value{0};
  std::array<S, N> derivative{};

  Dual() = default;
  Dual(int constant) : value(constant) {}  // NOLINT(google-explicit-constructor)
  explicit Dual(const S& constant) : value(constant) {}

  static Dual input(const S& value, std::size_t index) {
    Dual dual(value);
    dual.derivative[index] = S(1);
    return dual;
  }

  Dual& operator+=(const Dual& other) { return *this = *this + other; }
  Dual& operator-=(const Dual& other) { return *this = *this - other; }
  Dual& operator*=(const Dual& other) { return *this = *this * other; }
  Dual& operator/=(const Dual& other) {
    const S inverse = S(1) / other.value;
    value *= inverse;
    for (std::size_t i = 0; i < N; ++i) {
      derivative[i] = (derivative[i] - value * other.derivative[i]) * inverse;
    }
    return *this;
  }

  // These operators do not use +=, because the copy of an operand would cost as much as the operation.
  friend Dual operator+(const Dual& left, const Dual& right) {
    Dual sum(left.value + right.value);
    for (std::size_t i = 0; i < N; ++i) {
      sum.derivative[i] = left.derivative[i] + right.derivative[i];
    }
    return sum;
  }
  friend Dual operator-(const Dual& left, const Dual& right) {
    Dual difference(left.value - right.value);
    for (std::size_t i = 0; i < N; ++i) {
      difference.derivative[i] = left.derivative[i] - right.derivative[i];
    }
    return difference;
  }
  friend Dual operator*(const Dual& left, const Dual& right) {
    Dual product(left.value * right.value);
    for (std::size_t i = 0; i < N; ++i) {
      product.derivative[i] = left.derivative[i] * right.value + left.value * right.derivative[i];
    }
    return product;
  }
  friend Dual operator/(Dual left, const Dual& right) { return left /= right; }
  /// √x. Precondition: x > 0.
  friend Dual sqrt(const Dual& x) {
    using std::sqrt;
    if constexpr (std::totally_ordered<S>) {
      CAROM_EXPECTS(x.value > S(0), x.value);
    }
    Dual root(S(sqrt(x.value)));
    const S factor = S(1) / (S(2) * root.value);
    for (std::size_t i = 0; i < N; ++i) {
      root.derivative[i] = x.derivative[i] * factor;
    }
    return root;
  }
  friend Dual operator-(Dual dual) {
    dual.value = -dual.value;
    for (S& d : dual.derivative) {
      d = -d;
    }
    return dual;
  }
};

/// The least positive integer whose product with each value and derivative is without a denominator. S is a fraction.
template <Fraction S, std::size_t N>
[[nodiscard]] auto common_denominator(std::span<const Dual<S, N>> numbers) {
  std::vector<S> parts;
  parts.reserve((N + 1) * numbers.size());
  for (const Dual<S, N>& number : numbers) {
    parts.push_back(number.value);
    parts.insert(parts.end(), number.derivative.begin(), number.derivative.end());
  }
  return S(common_denominator(std::span<const S>(parts)));
}

}  // namespace carom::oracles

template <class S, std::size_t N>
struct Eigen::NumTraits<carom::oracles::Dual<S, N>>
    : carom::oracles::EigenScalar<carom::oracles::Dual<S, N>, 1, 8, 16> {};
