// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <carom/properties/invariants/theorems.hpp>

namespace carom::properties {

std::span<const Proved> proved_invariants() {
  static const std::vector<Proved> all{
      {"linear_momentum", {{"linear_momentum", "momentum.v"}}},
      {"angular_momentum", {{"angular_momentum", "momentum.v"}, {"angular_momentum_of_each", "momentum.v"}}},
      {"restitution",
       {{"restitution_of_frictionless", "laws_of_impulse.v"},
        {"restitution_of_reflection", "laws_of_impulse.v"},
        {"restitution_of_sticking", "laws_of_impulse.v"},
        {"restitution_of_rough_law", "friction.v"}}},
      {"non_penetration", {{"non_penetration", "laws_of_impulse.v"}}},
      {"push",
       {{"push_of_frictionless", "laws_of_impulse.v"},
        {"push_of_reflection", "laws_of_impulse.v"},
        {"push_of_rough", "friction.v"}}},
      {"separating_untouched", {{"separating_untouched", "laws_of_impulse.v"}}},
      {"immovable_untouched", {{"immovable_untouched", "laws_of_impulse.v"}}},
      {"frictionless_direction", {{"frictionless_direction", "laws_of_impulse.v"}}},
      {"reflection_plane", {{"reflection_plane", "laws_of_impulse.v"}}},
      {"sticks", {{"sticks", "laws_of_impulse.v"}}},
      {"friction_cone", {{"friction_cone", "friction.v"}}},
      {"energy", {{"energy_of_frictionless", "energy.v"}, {"energy_of_rough_law", "friction.v"}}},
      {"definite", {{"definite", "collision_matrix.v"}}},
      {"well_conditioned",
       {{"well_conditioned", "well_conditioned.v"},
        {"star_shaped_well_conditioned", "star_shaped.v"},
        {"bound_is_sharp", "star_shaped.v"}}},
      {"collinear_spin",
       {{"collinear_spin_of_frictionless", "laws_of_impulse.v"},
        {"collinear_spin_of_reflection", "laws_of_impulse.v"}}},
      {"swap", {{"swap", "relations.v"}}},
      {"galilean", {{"galilean", "relations.v"}}},
      {"translation", {{"translation", "relations.v"}}},
      {"rotation", {{"rotation", "relations.v"}}},
      {"reflection_symmetry", {{"reflection_symmetry", "relations.v"}}},
      {"unit_scaling", {{"unit_scaling", "relations.v"}}},
      {"homogeneous", {{"homogeneous", "relations.v"}}},
      {"repeat", {{"repeat", "laws_of_impulse.v"}}},
  };
  return all;
}

std::span<const Theorem> theorems_of(std::string_view invariant) {
  const std::span<const Proved> all = proved_invariants();
  const auto found = std::ranges::find(all, invariant, &Proved::invariant);
  return found == all.end() ? std::span<const Theorem>{} : std::span(found->theorems);
}

}  // namespace carom::properties
