// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>

int main() {
  carom::properties::GateOptions options;
  options.cases = 20;
  options.families = carom::properties::pointers_to(carom::properties::all_families());
  const auto subject = carom::subjects::subject_named("reflection-double");
  return subject && carom::properties::run_gate({*subject}, options).results[0].is_sound() ? 0 : 1;
}
