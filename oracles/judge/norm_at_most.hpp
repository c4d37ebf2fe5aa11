// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include <Eigen/Core>

#include <carom/collision/expects.hpp>
#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/exact/radical.hpp>

namespace carom::oracles {

/// Up to six numbers without heap memory, for the difference of the two sides of an equation.
template <class T>
class Components {
 public:
  using value_type = T;
  static constexpr std::size_t capacity = 6;

  /// Precondition: size() < capacity.
  void push_back(T number) {
    CAROM_EXPECTS(size_ < capacity, size_);
    numbers_[size_++] = std::move(number);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const T* begin() const { return numbers_.data(); }
  [[nodiscard]] const T* end() const { return numbers_.data() + size_; }
  [[nodiscard]] const T* data() const { return numbers_.data(); }
  [[nodiscard]] const T& operator[](std::size_t i) const { return numbers_[i]; }

 private:
  std::array<T, capacity> numbers_;
  std::size_t size_ = 0;
};

/// The components of left − right. Precondition: there are at most six.
template <class Derived, class OtherDerived>
[[nodiscard]] Components<typename Derived::Scalar> difference(const Eigen::MatrixBase<Derived>& left,
                                                              const Eigen::MatrixBase<OtherDerived>& right) {
  Components<typename Derived::Scalar> result;
  for (Eigen::Index i = 0; i < left.size(); ++i) {
    result.push_back(left[i] - right[i]);
  }
  return result;
}

namespace norm_bounds {

/// An upper bound of the relative rounding error of a sum of six squares and of a comparison with a square.
inline constexpr double rounding = 0x1p-45;

/// Enclosures decide only if `bound` is between these limits. The underflow of squares is negligible at the smaller
/// limit. The square of the larger limit is far from overflow.
inline constexpr double least = 0x1p-400;
inline constexpr double largest = 0x1p+400;

/// Σ size(v_i)².
template <class S, class T, class Size>
[[nodiscard]] S sum_of_squares(std::span<const T> vector, const Size& size) {
  S sum(0);
  for (const T& component : vector) {
    const S x = size(component);
    sum += x * x;
  }
  return sum;
}

}  // namespace norm_bounds

/// Whether ‖v‖ ≤ bound. Precondition: the bound is finite and not negative.
[[nodiscard]] bool norm_at_most(std::span<const Rational> vector, double bound);
[[nodiscard]] bool norm_at_most(std::span<const Radical> vector, double bound);

/// The same, or nullopt if the enclosures do not decide it. A² is the computed sum of the squared upper bounds of
/// |v_i|, and B² that of the lower bounds. Each has a relative rounding error below ρ = `norm_bounds::rounding`.
///
///   (1) true if A² (1 + ρ) ≤ bound² (1 − ρ), or if all upper bounds are 0;
///   (2) false if B² (1 − ρ) > bound² (1 + ρ).
[[nodiscard]] std::optional<bool> norm_at_most(std::span<const Enclosure> vector, double bound);

/// Rounded for print.
[[nodiscard]] inline double rounded(const Rational& number) { return to_double(number); }
[[nodiscard]] inline double rounded(const Radical& number) { return to_double(number); }
[[nodiscard]] inline double rounded(const Enclosure& number) { return number.middle(); }

/// ‖v‖, rounded.
template <class T>
[[nodiscard]] double norm(const Components<T>& vector) {
  return root_of_squares(vector.size(), [&](std::size_t i) { return rounded(vector[i]); });
}

}  // namespace carom::oracles
