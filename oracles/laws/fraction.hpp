// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>

#include <carom/collision/vector.hpp>

/// Linear maps of fractions. A sum of fractions looks for common divisors of long integers, which takes most of the
/// time of exact arithmetic. A sum of integers does not.
namespace carom::oracles {

/// A type whose numbers are fractions: Rational, Radical, or Dual of one of these. `common_denominator` returns the
/// least positive integer d for which all products with d are without a denominator.
template <class T>
concept Fraction = requires(std::span<const T> numbers) {
  common_denominator(numbers);
};

/// map(v) for a linear map. Of fractions, it is map(d v) / d, with the common denominator d of v.
template <class T, class Map>
[[nodiscard]] Vector3<T> mapped_linearly(const Vector3<T>& v, const Map& map) {
  if constexpr (Fraction<T>) {
    const T denominator(common_denominator(std::span<const T>(v.data(), 3)));
    return Vector3<T>(map(Vector3<T>(v * denominator)) / denominator);
  } else {
    return map(v);
  }
}

}  // namespace carom::oracles
