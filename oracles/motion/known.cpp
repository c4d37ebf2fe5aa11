// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/motion/known.hpp>

namespace carom::oracles {

Known known(const Enclosure& exact) {
  return {exact.middle(), (std::abs(exact.lower_part()) + exact.radius()) * enclosure::up};
}

Enclosure exact(const StepTime& time) {
  // A count of steps below 2⁵³ is a double.
  return Enclosure(time.step) * Enclosure(static_cast<double>(time.steps));
}

}  // namespace carom::oracles
