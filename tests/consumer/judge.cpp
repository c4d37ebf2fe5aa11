// SPDX-License-Identifier: BSL-1.0
// A sound solver passes the gate. A solver that returns its input fails.
#include <carom/impulse/frictionless.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/kit/subject.hpp>

int main() {
  const auto sound = [](const carom::impulse::Contact<double>& contact) {
    return carom::impulse::frictionless(contact);
  };
  const auto identity = [](const carom::Collision& collision) { return carom::unchanged(collision); };
  carom::properties::GateOptions options;
  options.cases = 20;
  options.families = carom::properties::pointers_to(carom::properties::all_families());
  const auto report =
      carom::properties::run_gate({carom::conformance::subject("sound", carom::Law::frictionless, sound),
                                   carom::conformance::subject("identity", carom::Law::frictionless, identity)},
                                  options);
  return report.results[0].is_sound() && !report.results[1].is_sound() ? 0 : 1;
}
