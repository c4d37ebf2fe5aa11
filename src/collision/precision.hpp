// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>
#include <string_view>

namespace carom {

/// The floating-point format that a subject computes in.
enum class Precision { binary32, binary64, extended };

[[nodiscard]] constexpr std::string_view name_of(Precision precision) {
  switch (precision) {
    case Precision::binary32:
      return "binary32";
    case Precision::binary64:
      return "binary64";
    case Precision::extended:
      break;
  }
  return "extended";
}

/// The unit roundoff u: half the distance from 1 to the next larger number.
[[nodiscard]] constexpr double unit_roundoff(Precision precision) {
  switch (precision) {
    case Precision::binary32:
      return std::numeric_limits<float>::epsilon() / 2.0;
    case Precision::binary64:
      return std::numeric_limits<double>::epsilon() / 2.0;
    case Precision::extended:
      break;
  }
  return static_cast<double>(std::numeric_limits<long double>::epsilon() / 2.0L);
}

/// η/u, with η the least positive number of the format. If |x| < η/u, the rounding error of x may exceed u |x|, but not
/// η. The result is 0 for formats in which every judged number is larger.
[[nodiscard]] constexpr double least_size_known_to_a_roundoff(Precision precision) {
  switch (precision) {
    case Precision::binary32:
      return static_cast<double>(std::numeric_limits<float>::denorm_min()) / unit_roundoff(Precision::binary32);
    case Precision::binary64:
    case Precision::extended:
      break;
  }
  return 0;
}

template <class S>
inline constexpr Precision precision_of = Precision::binary64;
template <>
inline constexpr Precision precision_of<float> = Precision::binary32;
template <>
inline constexpr Precision precision_of<long double> = Precision::extended;

}  // namespace carom
