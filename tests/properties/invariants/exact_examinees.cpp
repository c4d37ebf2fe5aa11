// SPDX-License-Identifier: GPL-3.0-or-later
#include <carom/collision/validate.hpp>
#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/sticking.hpp>

#include "examinee.hpp"

namespace carom::properties {
namespace {

using oracles::Rational;
using Contact = impulse::Contact<Rational>;

Contact contact_of(const Collision& collision) { return impulse::make_contact<Rational>(oracles::lift(collision)); }

Examinee exactly(std::string name, Model model, Outcome<Rational> (*solver)(const Contact&)) {
  Examinee examinee;
  examinee.name = std::move(name);
  examinee.model = model;
  examinee.yardstick.unit_roundoff = 0;
  examinee.solve = [solver](const Collision& collision) -> ExactAnswer {
    if (!validate(collision).empty()) {
      return Refused{"invalid"};
    }
    return oracles::LiftedOutcome(solver(contact_of(collision)));
  };
  examinee.collision_matrix = [](const JudgedCase& judged_case) -> std::optional<oracles::LiftedMatrix> {
    if (!judged_case.is_valid()) {
      return std::nullopt;
    }
    return oracles::LiftedMatrix(impulse::collision_matrix(contact_of(judged_case.generated().collision)));
  };
  return examinee;
}

}  // namespace

std::vector<Examinee> exact_examinees() {
  return {exactly("frictionless_rational", Model::frictionless, impulse::frictionless<Rational>),
          exactly("reflection_rational", Model::reflection, impulse::reflection<impulse::Ldlt, Rational>),
          exactly("sticking_rational", Model::sticking, impulse::sticking<impulse::Ldlt, Rational>),
          exactly("reflection_adjugate_rational", Model::reflection, impulse::reflection<impulse::Adjugate, Rational>)};
}

}  // namespace carom::properties
