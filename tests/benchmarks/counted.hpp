// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace carom::benchmarks {

/// The number of operations performed on scalars of the type Counted.
struct Operations {
  int additions = 0;
  int multiplications = 0;
  int divisions = 0;

  [[nodiscard]] int all() const { return additions + multiplications + divisions; }
};

class Counted {
 public:
  Counted() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): solvers write S(1)
  Counted(double number) : number_(number) {}

  static inline Operations operations;

  friend Counted operator-(const Counted& x) { return {-x.number_}; }  // a change of sign counts as free
  friend Counted operator+(const Counted& x, const Counted& y) {
    ++operations.additions;
    return {x.number_ + y.number_};
  }
  friend Counted operator-(const Counted& x, const Counted& y) {
    ++operations.additions;
    return {x.number_ - y.number_};
  }
  friend Counted operator*(const Counted& x, const Counted& y) {
    ++operations.multiplications;
    return {x.number_ * y.number_};
  }
  friend Counted operator/(const Counted& x, const Counted& y) {
    ++operations.divisions;
    return {x.number_ / y.number_};
  }
  friend Counted sqrt(const Counted& x) {
    ++operations.divisions;  // a root takes as long as a division
    return {std::sqrt(x.number_)};
  }
  Counted& operator+=(const Counted& y) { return *this = *this + y; }
  friend bool operator==(const Counted& x, const Counted& y) { return x.number_ == y.number_; }
  friend bool operator<(const Counted& x, const Counted& y) { return x.number_ < y.number_; }
  friend bool operator>(const Counted& x, const Counted& y) { return y < x; }

 private:
  double number_ = 0;
};

}  // namespace carom::benchmarks

template <>
struct Eigen::NumTraits<carom::benchmarks::Counted> : Eigen::NumTraits<double> {
  using Real = carom::benchmarks::Counted;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
};
