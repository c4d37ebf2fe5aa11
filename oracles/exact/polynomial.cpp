// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <carom/oracles/exact/polynomial.hpp>

namespace carom::oracles {
namespace {

Rational power_of_two(int exponent) { return Rational(1).times_power_of_two(exponent); }

/// The least k with |x| ≤ 2^k. Precondition: x ≠ 0.
int exponent_above(const Rational& x) {
  const Rational size = abs(x);
  int low = -1;
  int high = 1;
  while (size <= power_of_two(low)) {
    low *= 2;
  }
  while (power_of_two(high) < size) {
    high *= 2;
  }
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (power_of_two(middle) < size ? low : high) = middle;
  }
  return high;
}

/// Every root is at most 1 + max |a_i / a_n| (Cauchy): the exponent of a power of two above it.
int exponent_above_roots(const std::vector<Rational>& coefficients) {
  Rational largest(0);
  for (const Rational& one : coefficients) {
    largest = std::max(largest, abs(Rational(one / coefficients.back())));
  }
  return exponent_above(largest) + 1;
}

/// Quotient and remainder. Precondition: the divisor is not zero.
std::pair<Polynomial, Polynomial> divided(const Polynomial& dividend, const Polynomial& divisor) {
  std::vector<Rational> rest = dividend.coefficients();
  const std::vector<Rational>& by = divisor.coefficients();
  std::vector<Rational> quotient(rest.size() >= by.size() ? rest.size() - by.size() + 1 : 0);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = rest[k + by.size() - 1] / by.back();
    for (std::size_t i = 0; i < by.size(); ++i) {
      rest[k + i] -= quotient[k] * by[i];
    }
  }
  return {Polynomial(std::move(quotient)), Polynomial(std::move(rest))};
}

/// A positive multiple: the leading coefficient is ±1, so that the numbers of remainders do not grow as fast.
Polynomial normalised(const Polynomial& polynomial) {
  std::vector<Rational> coefficients = polynomial.coefficients();
  const Rational size = coefficients.empty() ? Rational(1) : abs(coefficients.back());
  for (Rational& one : coefficients) {
    one /= size;
  }
  return Polynomial(std::move(coefficients));
}

Polynomial negated(const Polynomial& polynomial) { return Polynomial() - polynomial; }

std::vector<Polynomial> sturm_sequence_of(const Polynomial& polynomial) {
  std::vector<Polynomial> sequence{normalised(polynomial), normalised(polynomial.derivative())};
  while (sequence.back().degree() > 0) {
    Polynomial rest = negated(divided(sequence[sequence.size() - 2], sequence.back()).second);
    if (rest.degree() < 0) {
      break;
    }
    sequence.push_back(normalised(rest));
  }
  return sequence;
}

/// Without the root zero, and with each other root once.
Polynomial with_simple_roots(const Polynomial& polynomial) {
  std::vector<Rational> coefficients = polynomial.coefficients();
  const auto first = std::find_if(coefficients.begin(), coefficients.end(), [](const Rational& x) { return x != 0; });
  coefficients.erase(coefficients.begin(), first);
  const Polynomial without_zero{std::move(coefficients)};
  if (without_zero.degree() < 1) {
    return without_zero;
  }
  const Polynomial common = sturm_sequence_of(without_zero).back();
  return common.degree() > 0 ? divided(without_zero, common).first : without_zero;
}

}  // namespace

Polynomial::Polynomial(std::vector<Rational> coefficients) : coefficients_(std::move(coefficients)) {
  while (!coefficients_.empty() && coefficients_.back() == 0) {
    coefficients_.pop_back();
  }
}

Rational Polynomial::operator()(const Rational& x) const {
  Rational value(0);
  for (auto coefficient = coefficients_.rbegin(); coefficient != coefficients_.rend(); ++coefficient) {
    value = value * x + *coefficient;
  }
  return value;
}

Polynomial Polynomial::derivative() const {
  std::vector<Rational> coefficients;
  for (std::size_t i = 1; i < coefficients_.size(); ++i) {
    coefficients.push_back(coefficients_[i] * Rational(static_cast<int>(i)));
  }
  return Polynomial(std::move(coefficients));
}

Polynomial operator+(const Polynomial& left, const Polynomial& right) {
  std::vector<Rational> sum(std::max(left.coefficients_.size(), right.coefficients_.size()));
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] = (i < left.coefficients_.size() ? left.coefficients_[i] : Rational(0)) +
             (i < right.coefficients_.size() ? right.coefficients_[i] : Rational(0));
  }
  return Polynomial(std::move(sum));
}

Polynomial operator-(const Polynomial& left, const Polynomial& right) {
  return left + Polynomial({Rational(-1)}) * right;
}

Polynomial operator*(const Polynomial& left, const Polynomial& right) {
  if (left.degree() < 0 || right.degree() < 0) {
    return {};
  }
  std::vector<Rational> product(left.coefficients_.size() + right.coefficients_.size() - 1);
  for (std::size_t i = 0; i < left.coefficients_.size(); ++i) {
    for (std::size_t j = 0; j < right.coefficients_.size(); ++j) {
      product[i + j] += left.coefficients_[i] * right.coefficients_[j];
    }
  }
  return Polynomial(std::move(product));
}

Polynomial quadratic_through(const Rational& at_zero, const Rational& at_one, const Rational& at_minus_one) {
  const Rational half(1, 2);
  return Polynomial({at_zero, half * (at_one - at_minus_one), half * (at_one + at_minus_one) - at_zero});
}

PositiveRoots::PositiveRoots(const Polynomial& polynomial) {
  const Polynomial simple = with_simple_roots(polynomial);
  if (simple.degree() < 1) {
    return;
  }
  sturm_sequence_ = sturm_sequence_of(simple);
  std::vector<Rational> reversed = simple.coefficients();
  std::reverse(reversed.begin(), reversed.end());
  isolate(-exponent_above_roots(reversed) - 1, exponent_above_roots(simple.coefficients()));
}

int PositiveRoots::variations_at(const Rational& x) const {
  int variations = 0;
  int last = 0;
  for (const Polynomial& one : sturm_sequence_) {
    const int sign = sign_of(one(x));
    variations += sign * last < 0 ? 1 : 0;
    last = sign != 0 ? sign : last;
  }
  return variations;
}

int PositiveRoots::count_in(const Interval& interval) const {
  return variations_at(interval.low) - variations_at(interval.high);
}

void PositiveRoots::isolate(int low, int high) {
  const Interval interval{power_of_two(low), power_of_two(high)};
  const int count = count_in(interval);
  if (count == 0) {
    return;
  }
  if (high - low == 1) {
    isolate(interval);
    return;
  }
  const int middle = low + (high - low) / 2;
  isolate(low, middle);
  isolate(middle, high);
}

void PositiveRoots::isolate(const Interval& interval) {
  const int count = count_in(interval);
  if (count == 1) {
    intervals_.push_back(interval);
  } else if (count > 1) {
    const Rational middle = (interval.low + interval.high) / 2;
    isolate(Interval{interval.low, middle});
    isolate(Interval{middle, interval.high});
  }
}

Interval PositiveRoots::refined(const Interval& interval, int bits) const {
  Interval result = interval;
  while (result.high - result.low > result.high.times_power_of_two(-bits)) {
    const Rational middle = (result.low + result.high) / 2;
    (count_in({result.low, middle}) == 1 ? result.high : result.low) = middle;
  }
  return result;
}

}  // namespace carom::oracles
