// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::subjects {

/// The two subjects of an engine, configured and as shipped, with `open` or `absent` still to be set: they are listed
/// whether the engine is installed or not. Neither is expected to pass: as configured they keep J⁻¹ in world
/// coordinates, which slender bodies show.
[[nodiscard]] inline std::vector<Subject> engine_claims(const std::string& name, std::string configured,
                                                        std::string as_shipped) {
  std::vector<Subject> claims(2);
  claims[0].name = name;
  claims[0].summary = std::move(configured) + "; fails on slender bodies";
  claims[1].name = name + "-as-shipped";
  claims[1].summary = std::move(as_shipped);
  for (Subject& claim : claims) {
    claim.expected_to_pass = false;
    claim.model = Model::frictionless;
    claim.precision = Precision::binary64;
  }
  return claims;
}

[[nodiscard]] inline std::vector<Subject> bullet_claims() {
  return engine_claims("bullet-double", "Bullet's sequential impulses: restitution threshold 0, no gyroscopic torque",
                       "Bullet's sequential impulses: the engine's defaults, step 1/60 s");
}

[[nodiscard]] inline std::vector<Subject> ode_claims() {
  return engine_claims("ode-double", "ODE's dWorldStep: CFM 0, no gyroscopic torque, step 1/60 s",
                       "ODE's dWorldStep: the engine's defaults, step 1/60 s");
}

/// The claims of an engine that this program was built without.
[[nodiscard]] inline std::vector<Subject> absent(std::vector<Subject> claims, const std::string& package) {
  for (Subject& claim : claims) {
    claim.absent = package + " was not found when this program was built";
  }
  return claims;
}

}  // namespace carom::subjects
