// SPDX-License-Identifier: BSL-1.0
// Solves many contacts at once with carom::batch: balls of 2 kg hit a fixed floor at 1, 2, 3, … m/s, with ε = 1/2.
#include <cstddef>
#include <iostream>

#include <carom/impulse/batch/solve.hpp>

// NOLINTNEXTLINE(bugprone-exception-escape): the program ends if memory runs out
int main() {
  constexpr std::size_t balls = 1000;
  carom::impulse::ContactBatch<double> contacts(balls);
  for (std::size_t i = 0; i < balls; ++i) {
    carom::Collision collision;
    collision.a.mass = 2;
    collision.a.position = {0, 1, 0};
    collision.a.velocity = {0, -static_cast<double>(i + 1), 0};
    collision.b.immovable = true;
    collision.restitution = 0.5;
    contacts.set(i, carom::impulse::make_contact<double>(collision));
  }

  carom::impulse::OutcomeBatch<double> outcomes(balls);
  carom::impulse::solve(contacts, carom::Law::frictionless, outcomes);

  for (std::size_t i = 0; i < balls; ++i) {
    if (outcomes.at(i).a.velocity[1] != 0.5 * static_cast<double>(i + 1)) {
      std::cerr << "ball " << i << " does not bounce as it should\n";
      return 1;
    }
  }
  std::cout << balls << " balls bounced, with " << name_of(carom::impulse::best_instruction_set()) << '\n';
}
