// SPDX-License-Identifier: BSL-1.0
// A ball of 2 kg hits a fixed floor at 3 m/s, ε = 1/2.
#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/rough.hpp>
#include <carom/impulse/sticking.hpp>

int main() {
  carom::Collision collision;
  collision.a.mass = 2;
  collision.a.position = {0, 1, 0};
  collision.a.velocity = {0, -3, 0};
  collision.b.immovable = true;
  collision.restitution = 0.5;
  const auto contact = carom::impulse::make_contact<double>(collision);
  const bool frictionless = carom::impulse::frictionless(contact).a.velocity[1] == 1.5;
  // The default 3×3 solve is Ldlt.
  const bool defaults = carom::impulse::reflection(contact).a.velocity[1] == 1.5 &&
                        carom::impulse::sticking(contact).a.velocity[1] == 1.5 &&
                        carom::impulse::rough(contact).a.velocity[1] == 1.5 &&
                        carom::impulse::coulomb(contact).a.velocity[1] == 1.5;
  const bool reflection = carom::impulse::reflection<carom::impulse::Ldlt>(contact).a.velocity[1] == 1.5;
  return frictionless && defaults && reflection ? 0 : 1;
}
