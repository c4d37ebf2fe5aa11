// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include <carom/properties/gate/histogram.hpp>

namespace carom::properties {

/// Correct digits in bins of 0.01 from −20 to 40. 40 stands for an exact outcome. The middle of a bin rounds to the
/// same tenth as every number in the bin. One more bin, with the middle −∞, holds everything below −20, and NaN.
struct DigitsScale {
  static constexpr int lowest = -20;
  static constexpr int highest = 40;
  static constexpr int of_each = 100;
  static constexpr std::size_t bins = 2 + (highest - lowest) * of_each;  // two more: below −20, and 40 itself

  [[nodiscard]] static std::size_t bin_of(double digits) {
    if (!(digits >= lowest)) {
      return 0;
    }
    return 1 + static_cast<std::size_t>((std::fmin(digits, highest) - lowest) * of_each);
  }

  [[nodiscard]] static double middle_of(std::size_t bin) {
    if (bin == 0) {
      return -std::numeric_limits<double>::infinity();
    }
    return (2 * static_cast<double>(bin) - 1) / (2 * of_each) + lowest;
  }
};

/// Times in nanoseconds from 2⁻¹⁰ to 2⁵⁴ (half a year), in 64 bins per octave. The middle of a bin has a relative error
/// below 1/128. The outer bins also hold the times outside this range.
struct TimeScale {
  static constexpr int lowest_exponent = -9;  // of std::frexp: 2⁻¹⁰ is ½ · 2⁻⁹
  static constexpr int octaves = 64;
  static constexpr int of_each = 64;
  static constexpr std::size_t bins = std::size_t{octaves} * of_each;

  [[nodiscard]] static std::size_t bin_of(double nanoseconds) {
    int exponent = 0;
    const double mantissa = std::frexp(nanoseconds, &exponent);  // from ½ to 1
    if (!(nanoseconds > 0) || exponent < lowest_exponent) {
      return 0;
    }
    if (exponent >= lowest_exponent + octaves) {
      return bins - 1;
    }
    return static_cast<std::size_t>((exponent - lowest_exponent) * of_each) +
           static_cast<std::size_t>((2 * mantissa - 1) * of_each);
  }

  [[nodiscard]] static double middle_of(std::size_t bin) {
    const auto octave = static_cast<int>(bin / of_each);
    const auto part = static_cast<double>(bin % of_each);
    return std::ldexp(1 + (part + 0.5) / of_each, octave + lowest_exponent - 1);
  }
};

}  // namespace carom::properties
