// SPDX-License-Identifier: BSL-1.0
#include <type_traits>

#include <carom/collision/expects.hpp>
#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/rough.hpp>
#include <carom/impulse/sticking.hpp>
#include <carom/scene/polyhedra/contact_impulse.hpp>

namespace carom::scene {
namespace {

template <class S>
Outcome<double> in_double(const Outcome<S>& outcome) {
  return map_outcome<double>(outcome, [](const S& x) { return static_cast<double>(x); });
}

template <class S>
Outcome<double> struck_in(Law law, const Collision& collision) {
  using impulse::Ldlt;
  const impulse::Contact<S> contact = impulse::make_contact<S>(collision);
  switch (law) {
    case Law::frictionless:
      return in_double(impulse::frictionless<S>(contact));
    case Law::reflection:
      return in_double(impulse::reflection<Ldlt, S>(contact));
    case Law::sticking:
      return in_double(impulse::sticking<Ldlt, S>(contact));
    case Law::coulomb: {
      // The search for the slip needs the elementary functions of a built-in type.
      using Searched = std::conditional_t<std::is_floating_point_v<S>, S, long double>;
      return in_double(impulse::coulomb(impulse::make_contact<Searched>(collision)));
    }
    case Law::rough:
    case Law::any:
      break;
  }
  return in_double(impulse::rough<Ldlt, S>(contact));
}

/// Restores the velocities of immovable bodies, because rounding to the solver's precision changes them.
Outcome<double> with_immovable_kept(Outcome<double> outcome, const Collision& collision) {
  const Outcome<double> before = unchanged(collision);
  if (collision.a.immovable) {
    outcome.a = before.a;
  }
  if (collision.b.immovable) {
    outcome.b = before.b;
  }
  return outcome;
}

}  // namespace

Outcome<double> struck_bodies(Law law, Precision precision, const Collision& collision) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  CAROM_EXPECTS(law != Law::any);
  switch (precision) {
    case Precision::binary32:
      return with_immovable_kept(struck_in<float>(law, collision), collision);
    case Precision::binary64:
      return with_immovable_kept(struck_in<double>(law, collision), collision);
    case Precision::extended:
      break;
  }
  return with_immovable_kept(struck_in<impulse::DoubleDouble>(law, collision), collision);
}

double parting_speed(const Collision& collision) {
  return impulse::normal_velocity(impulse::make_contact<double>(collision)) /
         impulse::without_extreme_length<double>(collision.normal).norm();
}

Outcome<double> sent_apart(const Collision& collision, double speed) {
  impulse::Contact<double> contact = impulse::make_contact<double>(collision);
  // The impulse is that of a plastic impact (ε = 0) at the missing speed.
  contact.restitution = 0;
  const double missing = impulse::normal_velocity(contact) - speed * contact.normal.norm();
  return with_immovable_kept(impulse::apply_impulse(contact, impulse::frictionless_impulse(contact, missing)),
                             collision);
}

}  // namespace carom::scene
