// SPDX-License-Identifier: BSL-1.0
#include <optional>
#include <utility>

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

/// `solve` takes a contact and a function that receives the collision matrix. `solve` returns an outcome.
template <class Solve>
Examinee exactly(std::string name, Law law, Solve solve) {
  Examinee examinee;
  examinee.name = std::move(name);
  examinee.law = law;
  examinee.shows_matrix = law != Law::frictionless;
  examinee.solve = [solve](const Collision& collision) -> ExactAnswer {
    if (!validate(collision).empty()) {
      return Refused{"invalid"};
    }
    std::optional<Matrix3<Rational>> seen;
    const Outcome<Rational> outcome =
        solve(contact_of(collision), [&](const Matrix3<Rational>& matrix) { seen = matrix; });
    return oracles::LiftedOutcome(SolvedOutcome<Rational>(outcome, seen));
  };
  return examinee;
}

template <class Solve>
Examinee reflection_exactly(std::string name) {
  return exactly(std::move(name), Law::reflection, [](const Contact& contact, const auto& see) {
    return apply_impulse(contact, impulse::reflection_impulse<Solve>(contact, normal_velocity(contact), see));
  });
}

}  // namespace

std::vector<Examinee> exact_examinees() {
  return {exactly("frictionless_rational", Law::frictionless,
                  [](const Contact& contact, const auto& /*see*/) { return impulse::frictionless(contact); }),
          reflection_exactly<impulse::Ldlt>("reflection_rational"),
          exactly("sticking_rational", Law::sticking,
                  [](const Contact& contact, const auto& see) {
                    return apply_impulse(contact, impulse::sticking_impulse(contact, normal_velocity(contact), see));
                  }),
          reflection_exactly<impulse::Adjugate>("reflection_adjugate_rational")};
}

}  // namespace carom::properties
