// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>

#include <carom/collision/precision.hpp>

namespace carom::scene {

/// The numbers that the precision of the impulses knows to a roundoff: masses and moments are of them.
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
