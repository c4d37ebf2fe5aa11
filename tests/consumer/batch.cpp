// SPDX-License-Identifier: BSL-1.0
// Balls of 2 kg hit a fixed floor at 3 m/s, ε = 1/2.
#include <carom/impulse/batch/solve.hpp>

int main() {
  carom::Collision collision;
  collision.a.mass = 2;
  collision.a.position = {0, 1, 0};
  collision.a.velocity = {0, -3, 0};
  collision.b.immovable = true;
  collision.restitution = 0.5;
  carom::impulse::ContactBatch<float> contacts(21);
  carom::impulse::OutcomeBatch<float> outcomes(21);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    contacts.set(i, carom::impulse::make_contact<float>(collision));
  }
  carom::impulse::solve(contacts, carom::Law::reflection, outcomes);
  return outcomes.at(0).a.velocity[1] == 1.5F && outcomes.at(20).a.velocity[1] == 1.5F ? 0 : 1;
}
