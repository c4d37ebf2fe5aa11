// SPDX-License-Identifier: BSL-1.0
// The gate as a library: a sound solver passes, one that returns its input does not.
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/session.hpp>

int main() {
  carom::Subject identity;
  identity.name = "identity";
  identity.model = carom::Model::frictionless;
  identity.open = [] {
    return carom::subjects::session_of([](const carom::Collision& collision) -> carom::Answer {
      return carom::map_outcome<long double>(carom::unchanged(collision), [](double x) { return x; });
    });
  };
  carom::properties::GateOptions options;
  options.cases = 20;
  options.families = {carom::properties::family_named("generic")};
  const auto report =
      carom::properties::run_gate({*carom::subjects::subject_named("frictionless-double"), identity}, options);
  return report.results[0].is_sound() && !report.results[1].is_sound() ? 0 : 1;
}
