// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <carom/oracles/judge/norm_at_most.hpp>

namespace carom::oracles {
namespace {

/// At most six squares or hypotenuses, each good to an ulp or two.
constexpr double rounding = 0x1p-45;

/// By the squares, where these are in the range of binary64; what underflows is nothing beside the bound's own square.
template <class T>
std::optional<bool> norm_at_most_by_squares(std::span<const T> vector, double bound) {
  double above = 0;
  double below = 0;
  for (const T& component : vector) {
    above += component.magnitude_above() * component.magnitude_above();
    below += component.magnitude_below() * component.magnitude_below();
  }
  if (above * (1 + rounding) <= bound * bound * (1 - rounding)) {
    return true;
  }
  if (below * (1 - rounding) > bound * bound * (1 + rounding)) {
    return false;
  }
  return std::nullopt;
}

template <class T>
std::optional<bool> norm_at_most_by_bounds(std::span<const T> vector, double bound) {
  constexpr double least = 0x1p-400;
  constexpr double largest = 0x1p+400;
  if (bound >= least && bound <= largest) {
    return norm_at_most_by_squares(vector, bound);
  }
  double above = 0;
  double below = 0;
  for (const T& component : vector) {
    above = std::hypot(above, component.magnitude_above());
    below = std::hypot(below, component.magnitude_below());
  }
  if (above * (1 + rounding) <= bound) {
    return true;
  }
  if (below * (1 - rounding) > bound) {
    return false;
  }
  return std::nullopt;
}

}  // namespace

bool norm_at_most(std::span<const Rational> vector, double bound) {
  Rational squared(0);
  for (const Rational& component : vector) {
    squared += component * component;
  }
  return squared <= Rational(bound) * Rational(bound);
}

std::optional<bool> norm_at_most(std::span<const Enclosure> vector, double bound) {
  return norm_at_most_by_bounds(vector, bound);
}

std::optional<bool> norm_at_most(std::span<const Approximation> vector, double bound) {
  return norm_at_most_by_bounds(vector, bound);
}

}  // namespace carom::oracles
