// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>

namespace carom::oracles {

class Enclosure;

/// A known answer: |exact − value| ≤ bound.
struct Known {
  double value = 0;
  double bound = 0;
};

[[nodiscard]] Known known(const Enclosure& exact);

/// The time n h, without rounding.
struct StepTime {
  double step = 0;          // h > 0 [s]
  std::uint64_t steps = 0;  // n
};

[[nodiscard]] Enclosure exact(const StepTime& time);

}  // namespace carom::oracles
