// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstdint>

namespace carom::properties::diagnosis {

/// The number of violated cases that a hint needs. If at most half of all violated cases have a property, five random
/// ones all have it with a probability of at most 2⁻⁵ < 1/20. For four, the bound is 1/16.
inline constexpr std::uint64_t least_violated = 5;

/// An upper bound of the probability that at least `found` of `drawn` cases lie in a part of a set. The cases are drawn
/// by chance from the set, and the part is the fraction `share` of the set. Source: W. Hoeffding, "Probability
/// inequalities for sums of bounded random variables", J. Amer. Statist. Assoc. 58, 1963, theorem 1, and section 6 for
/// draws without replacement. Preconditions: 0 < found ≤ drawn; 0 < share ≤ 1.
[[nodiscard]] inline double chance_bound(std::uint64_t found, std::uint64_t drawn, double share) {
  const double fraction = static_cast<double>(found) / static_cast<double>(drawn);
  if (fraction <= share) {
    return 1;
  }
  const double rest = 1 - fraction;
  const double of_rest = rest > 0 ? rest * std::log((1 - share) / rest) : 0;
  return std::exp(static_cast<double>(drawn) * (fraction * std::log(share / fraction) + of_rest));
}

}  // namespace carom::properties::diagnosis
