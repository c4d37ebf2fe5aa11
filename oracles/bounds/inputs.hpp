// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/outcome.hpp>
#include <carom/oracles/bounds/dual.hpp>
#include <carom/oracles/bounds/quantities.hpp>

/// The stored numbers of a collision and of an outcome, as the inputs of forward differentiation.
namespace carom::oracles {

/// The lengths of derivative arrays. A collision has up to 43 numbers and an outcome 12; the lengths are multiples of
/// four.
inline constexpr std::size_t collision_inputs = 44;
inline constexpr std::size_t outcome_inputs = 12;

template <class S, std::size_t N>
struct DualInputs {
  BasicCollision<Dual<S, N>> collision;
  std::vector<Quantity> quantities;
};

/// The collision in dual numbers, with its j-th number as input j. `convert` maps a double to S.
template <class S, std::size_t N, class Convert>
[[nodiscard]] DualInputs<S, N> dual_inputs(const Collision& collision, Convert&& convert) {
  DualInputs<S, N> inputs;
  std::size_t next = 0;
  inputs.collision =
      map_numbers<Dual<S, N>>(collision, [&](double number) { return Dual<S, N>::input(convert(number), next++); });
  inputs.quantities = quantities_of(collision);
  return inputs;
}

}  // namespace carom::oracles
