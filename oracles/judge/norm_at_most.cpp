// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/collision/expects.hpp>
#include <carom/oracles/judge/norm_at_most.hpp>
#include <carom/oracles/numbers/norm_bounds.hpp>

namespace carom::oracles {
namespace {

template <class T>
bool is_at_most(std::span<const T> vector, double bound) {
  CAROM_EXPECTS(std::isfinite(bound), bound);
  T squared(0);
  for (const T& component : vector) {
    squared += component * component;
  }
  return squared <= T(bound) * T(bound);
}

}  // namespace

bool norm_at_most(std::span<const Rational> vector, double bound) { return is_at_most(vector, bound); }

bool norm_at_most(std::span<const Radical> vector, double bound) { return is_at_most(vector, bound); }

std::optional<bool> norm_at_most(std::span<const Enclosure> vector, double bound) {
  return norm_at_most_by_bounds(vector, bound);
}

}  // namespace carom::oracles
