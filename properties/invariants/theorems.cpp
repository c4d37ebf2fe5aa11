// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <iterator>

#include <carom/properties/invariants/theorems.hpp>

namespace carom::properties {
namespace {

const Proved* proved_named(std::string_view invariant) {
  const std::span<const Proved> all = proved_invariants();
  const auto found = std::ranges::find(all, invariant, &Proved::invariant);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Proved> proved_invariants() {
  using enum ProvedOf;
  static const std::vector<Proved> all{
      {"linear_momentum", every_impulse, {{"linear_momentum", "momentum.v"}}},
      {"angular_momentum",
       every_impulse,
       {{"angular_momentum", "momentum.v"}, {"angular_momentum_of_each", "momentum.v"}}},
      {"restitution",
       its_laws,
       {{"restitution_of_every_law", "every_law.v"},
        {"restitution_of_frictionless", "laws_of_impulse.v"},
        {"restitution_of_reflection", "laws_of_impulse.v"},
        {"restitution_of_sticking", "laws_of_impulse.v"},
        {"restitution_of_rough_law", "friction.v"}}},
      {"non_penetration",
       its_laws,
       {{"non_penetration_of_every_law", "every_law.v"}, {"non_penetration", "laws_of_impulse.v"}}},
      {"push",
       its_laws,
       {{"push_of_frictionless", "laws_of_impulse.v"},
        {"push_of_reflection", "laws_of_impulse.v"},
        {"push_of_rough", "friction.v"}}},
      {"separating_untouched", every_impulse, {{"separating_untouched", "laws_of_impulse.v"}}},
      {"immovable_untouched", every_impulse, {{"immovable_untouched", "laws_of_impulse.v"}}},
      {"frictionless_direction", its_laws, {{"frictionless_direction", "laws_of_impulse.v"}}},
      {"reflection_plane", its_laws, {{"reflection_plane", "laws_of_impulse.v"}}},
      {"sticks", its_laws, {{"sticks", "laws_of_impulse.v"}}},
      {"friction_cone", its_laws, {{"friction_cone", "friction.v"}}},
      {"energy",
       its_laws,
       {{"energy_of_frictionless", "energy.v"},
        {"energy_of_rough_law", "friction.v"},
        {"energy_of_frictionless_with_driven_walls", "driven_walls.v"},
        {"energy_of_rough_with_driven_walls", "driven_walls.v"}}},
      {"definite", every_impulse, {{"definite", "collision_matrix.v"}}},
      {"well_conditioned",
       every_impulse,
       {{"well_conditioned", "well_conditioned.v"},
        {"star_shaped_well_conditioned", "star_shaped.v"},
        {"star_shaped_condition_number", "star_shaped.v"},
        {"bound_is_sharp", "star_shaped.v"}}},
      {"matrix_used",
       every_impulse,
       {{"velocity_change", "collision_matrix.v"}, {"collision_matrix_symmetric", "collision_matrix.v"}}},
      {"collinear_spin",
       its_laws,
       {{"collinear_spin_of_frictionless", "laws_of_impulse.v"},
        {"collinear_spin_of_reflection", "laws_of_impulse.v"}}},
      {"swap", its_laws, {{"swap", "relations.v"}}},
      {"galilean", its_laws, {{"galilean", "relations.v"}}},
      {"translation", its_laws, {{"translation", "relations.v"}}},
      {"rotation", its_laws, {{"rotation", "relations.v"}, {"answer_turned", "turned_descriptions.v"}}},
      {"reflection_symmetry",
       its_laws,
       {{"reflection_symmetry", "relations.v"}, {"answer_mirrored", "turned_descriptions.v"}}},
      {"unit_scaling", its_laws, {{"unit_scaling", "relations.v"}}},
      {"homogeneous", its_laws, {{"homogeneous", "relations.v"}}},
      {"repeat", its_laws, {{"repeat_of_every_law", "every_law.v"}, {"repeat", "laws_of_impulse.v"}}},
  };
  return all;
}

std::span<const Theorem> theorems_of(std::string_view invariant) {
  const Proved* found = proved_named(invariant);
  return found == nullptr ? std::span<const Theorem>{} : std::span(found->theorems);
}

std::vector<Model> proved_models(const Invariant& invariant) {
  const Proved* found = proved_named(invariant.name);
  std::vector<Model> models;
  if (found != nullptr) {
    std::ranges::copy_if(invariant.models, std::back_inserter(models), [&](Model model) {
      return found->of == ProvedOf::every_impulse || determines_outcome(model);
    });
  }
  return models;
}

}  // namespace carom::properties
