// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <Eigen/Core>

#include <carom/collision/expects.hpp>

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

}  // namespace carom::oracles
