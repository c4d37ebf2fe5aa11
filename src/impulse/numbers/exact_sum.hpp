// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <carom/collision/expects.hpp>

namespace carom::impulse {

/// An exact sum of up to `most_products` products of up to three doubles, as a fixed-point number that is long enough
/// for every such product (U. Kulisch, "Computer Arithmetic and Validity", 2nd ed. 2013, ch. 8, for products of two
/// numbers).
class ExactSum {
 public:
  static constexpr std::int64_t most_products = std::int64_t{1} << 29;

  /// Adds x y z. Precondition: x, y and z are finite.
  void add(double x, double y, double z = 1) {
    CAROM_EXPECTS(std::isfinite(x) && std::isfinite(y) && std::isfinite(z), x, y, z);
    const Parts a(x);
    const Parts b(y);
    const Parts c(z);
    const std::array<std::uint64_t, 6> product = times(times(a.digits, b.digits), c.digits);
    const std::int64_t sign = a.sign * b.sign * c.sign;
    const std::size_t place = a.place + b.place + c.place;
    const std::size_t shift = place % digit_bits;
    const std::size_t first = place / digit_bits;
    for (std::size_t k = 0; k < product.size(); ++k) {
      const std::uint64_t shifted = product[k] << shift;
      digits_[first + k] += sign * static_cast<std::int64_t>(shifted & digit_mask);
      digits_[first + k + 1] += sign * static_cast<std::int64_t>(shifted >> digit_bits);
    }
    begin_ = std::min(begin_, first);
    end_ = std::max(end_, first + product.size() + 1);
  }

  /// −1, 0 or 1.
  [[nodiscard]] int sign() const {
    std::int64_t carry = 0;
    bool zero = true;
    for (std::size_t k = begin_; k < end_; ++k) {
      const std::int64_t digit = digits_[k] + carry;
      carry = digit >> digit_bits;
      zero = zero && (digit & digit_mask) == 0;
    }
    return carry < 0 ? -1 : (carry > 0 || !zero ? 1 : 0);
  }

  /// The sum, rounded; 0 or infinite if it is beyond the range of double. If the result is a normal number, its
  /// relative error is at most 2⁻⁵⁰: two additions are rounded, and the omitted digits are below 2⁻⁶⁴ of the sum.
  [[nodiscard]] double approximately() const {
    const int s = sign();
    std::int64_t carry = 0;
    std::array<std::uint64_t, digit_count + 1> magnitude{};
    for (std::size_t k = begin_; k < end_; ++k) {
      const std::int64_t digit = s * digits_[k] + carry;
      carry = digit >> digit_bits;
      magnitude[k] = static_cast<std::uint64_t>(digit) & digit_mask;
    }
    std::size_t top = end_;
    magnitude[top] = static_cast<std::uint64_t>(carry);
    while (top > begin_ && magnitude[top] == 0) {
      --top;
    }
    double sum = 0;  // of the three highest digits: at least 65 bits, because the first is not 0
    for (std::size_t k = 0; k < 3 && k <= top; ++k) {
      sum += std::ldexp(static_cast<double>(magnitude[top - k]), -static_cast<int>(digit_bits * k));
    }
    return s * std::ldexp(sum, static_cast<int>(digit_bits * top) - lowest_bit);
  }

 private:
  static constexpr std::size_t digit_bits = 32;
  static constexpr std::int64_t digit_mask = 0xffffffff;
  static constexpr int least_exponent = 1074;  // every double is a multiple of 2^−1074 and below 2^1024
  static constexpr int lowest_bit = 3 * least_exponent;
  static constexpr std::size_t digit_count = (3 * (least_exponent + 1024)) / digit_bits + 3;

  // For each product, `add` adds at most two numbers below 2³² to each digit. `sign()` adds a carry below 2³².
  static_assert(most_products <= (std::numeric_limits<std::int64_t>::max() - digit_mask) / (2 * digit_mask));
  // `Parts::place` is at most 2045. A product has six digits and a carry.
  static_assert((3 * 2045) / digit_bits + 7 <= digit_count);

  /// x = sign · (digits[0] + 2³² digits[1]) · 2^(place − 1074).
  struct Parts {
    explicit Parts(double x) {
      const auto bits = std::bit_cast<std::uint64_t>(x);
      const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
      const std::size_t exponent = bits >> 52 & 0x7ff;
      const std::uint64_t mantissa = exponent == 0 ? fraction : fraction | std::uint64_t{1} << 52;
      sign = bits >> 63 == 0 ? 1 : -1;
      place = exponent == 0 ? 0 : exponent - 1;
      digits = {mantissa & digit_mask, mantissa >> digit_bits};
    }
    std::int64_t sign;
    std::size_t place;
    std::array<std::uint64_t, 2> digits;
  };

  template <std::size_t N>
  static std::array<std::uint64_t, N + 2> times(const std::array<std::uint64_t, N>& x,
                                                const std::array<std::uint64_t, 2>& y) {
    std::array<std::uint64_t, N + 2> product{};
    for (std::size_t j = 0; j < 2; ++j) {
      std::uint64_t carry = 0;
      for (std::size_t i = 0; i < N; ++i) {
        const std::uint64_t digit = product[i + j] + x[i] * y[j] + carry;  // at most 2⁶⁴ − 1
        product[i + j] = digit & digit_mask;
        carry = digit >> digit_bits;
      }
      product[N + j] = carry;
    }
    return product;
  }

  std::array<std::int64_t, digit_count> digits_{};  // digits of base 2³², the lowest first, with pending carries
  std::size_t begin_ = digit_count;                 // digits outside of [begin_, end_) are 0
  std::size_t end_ = 0;
};

}  // namespace carom::impulse
