// SPDX-License-Identifier: BSL-1.0
// The lines of docs/guide/plan.md solve balls of 2 kg that hit a fixed floor at 3 m/s, ε = 1/2.
#include <carom/impulse/batch/solve.hpp>

namespace {

constexpr std::size_t n = 21;

carom::impulse::Contact<double> contact(std::size_t /*place*/) {
  carom::Collision collision;
  collision.a.mass = 2;
  collision.a.position = {0, 1, 0};
  collision.a.velocity = {0, -3, 0};
  collision.b.immovable = true;
  collision.restitution = 0.5;
  return carom::impulse::make_contact<double>(collision);
}

bool is_right = false;

void use(const carom::Outcome<double>& outcome) { is_right = outcome.a.velocity[1] == 1.5; }

}  // namespace

int main() {
#include LINES_OF_PLAN
  return is_right ? 0 : 1;
}
