// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/collision/expects.hpp>
#include <carom/oracles/judge/norm_at_most.hpp>

namespace carom::oracles {
namespace {

template <class T>
bool is_at_most(std::span<const T> vector, double bound) {
  CAROM_EXPECTS(std::isfinite(bound) && bound >= 0, bound);
  return norm_bounds::sum_of_squares<T>(vector, [](const T& x) -> const T& { return x; }) <= T(bound) * T(bound);
}

}  // namespace

bool norm_at_most(std::span<const Rational> vector, double bound) { return is_at_most(vector, bound); }

bool norm_at_most(std::span<const Radical> vector, double bound) { return is_at_most(vector, bound); }

std::optional<bool> norm_at_most(std::span<const Enclosure> vector, double bound) {
  CAROM_EXPECTS(std::isfinite(bound) && bound >= 0, bound);
  const auto above_of = [](const Enclosure& component) { return component.magnitude_above(); };
  const auto below_of = [](const Enclosure& component) { return component.magnitude_below(); };
  if (std::all_of(vector.begin(), vector.end(), [&](const Enclosure& component) { return above_of(component) == 0; })) {
    return true;
  }
  if (bound < norm_bounds::least || bound > norm_bounds::largest) {
    return std::nullopt;
  }
  const double above = norm_bounds::sum_of_squares<double>(vector, above_of);
  const double below = norm_bounds::sum_of_squares<double>(vector, below_of);
  if (above * (1 + norm_bounds::rounding) <= bound * bound * (1 - norm_bounds::rounding)) {
    return true;
  }
  return below * (1 - norm_bounds::rounding) > bound * bound * (1 + norm_bounds::rounding) ? std::optional(false)
                                                                                           : std::nullopt;
}

}  // namespace carom::oracles
