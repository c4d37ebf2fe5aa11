// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>

#include <carom/collision/precision.hpp>

namespace carom::scene {

/// The range of numbers that a precision rounds with a relative error of at most its unit roundoff. Masses and moments
/// must lie in this range.
struct KnownRange {
  double least, greatest;
  [[nodiscard]] bool contains(double value) const { return value >= least && value <= greatest; }
};

[[nodiscard]] inline KnownRange known_range(Precision precision) {
  if (precision == Precision::binary32) {
    return {std::numeric_limits<float>::min(), std::numeric_limits<float>::max()};
  }
  return {std::numeric_limits<double>::min(), std::numeric_limits<double>::max()};
}

}  // namespace carom::scene
