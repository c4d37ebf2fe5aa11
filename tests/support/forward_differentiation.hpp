// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <initializer_list>

#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/bounds/inputs.hpp>

/// Differentiates a law by dual numbers over enclosures (intervals), to check the judge's implicit differentiation.
namespace carom::unit {

using EnclosedDual = oracles::Dual<oracles::Enclosure, oracles::collision_inputs>;

[[nodiscard]] inline oracles::DualInputs<oracles::Enclosure, oracles::collision_inputs> enclosed_inputs(
    const Collision& collision) {
  return oracles::dual_inputs<oracles::Enclosure, oracles::collision_inputs>(
      collision, [](double x) { return oracles::Enclosure(x); });
}

/// An upper bound of Σ_q ‖∂y/∂q‖ ‖q‖ for a vector y with these components.
[[nodiscard]] inline double sensitivity_above(std::initializer_list<const EnclosedDual*> components,
                                              const std::vector<oracles::Quantity>& quantities) {
  return oracles::sum_over_quantities(quantities, components.size(), [&](std::size_t i, std::size_t j) {
    return components.begin()[i]->derivative[j].magnitude_above();
  });
}

/// A lower bound of the same sum.
[[nodiscard]] inline double sensitivity_below(std::initializer_list<const EnclosedDual*> components,
                                              const std::vector<oracles::Quantity>& quantities) {
  return oracles::sum_over_quantities(quantities, components.size(), [&](std::size_t i, std::size_t j) {
    return components.begin()[i]->derivative[j].magnitude_below();
  });
}

}  // namespace carom::unit
