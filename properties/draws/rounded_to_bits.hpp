// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

namespace carom::properties {

/// The number, rounded to this many bits. Preconditions: the number is finite; `bits` is positive.
[[nodiscard]] inline double rounded_to_bits(double number, int bits) {
  int exponent = 0;
  const double mantissa = std::frexp(number, &exponent);
  return std::ldexp(std::round(std::ldexp(mantissa, bits)), exponent - bits);
}

}  // namespace carom::properties
