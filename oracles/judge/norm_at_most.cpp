// SPDX-License-Identifier: GPL-3.0-or-later
#include <carom/oracles/judge/norm_at_most.hpp>
#include <carom/oracles/numbers/norm_bounds.hpp>

namespace carom::oracles {
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
