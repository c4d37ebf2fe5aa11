// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::subjects {

/// How an engine is posed a contact.
struct EngineSetting {
  Model model;  // frictionless, or coulomb
  bool configured;

  /// As the programs that speak for engines are told it.
  [[nodiscard]] std::vector<std::string> words() const {
    return {configured ? "configured" : "as-shipped", std::string(name_of(model))};
  }
};

/// Of the subjects of an engine, in their order.
inline constexpr std::array<EngineSetting, 4> engine_settings{
    {{Model::frictionless, true}, {Model::frictionless, false}, {Model::coulomb, true}, {Model::coulomb, false}}};

/// What an engine is called, and what its subjects are said to be.
struct EngineSummary {
  std::string name;        // of the subject that is configured and frictionless; the others' begin with it
  std::string engine;      // what it is of the engine
  std::string configured;  // its settings
  std::string friction;    // what its friction is in place of coulomb's
};

/// The subjects of an engine, with `open` or `absent` still to be set: they are listed whether the engine is installed
/// or not. None is expected to pass: as configured they keep J⁻¹ in world coordinates, which slender bodies show, and
/// their friction is not the law's.
[[nodiscard]] inline std::vector<Subject> engine_claims(const EngineSummary& summary, Precision precision) {
  std::vector<Subject> claims;
  for (const EngineSetting& setting : engine_settings) {
    const bool has_friction = setting.model == Model::coulomb;
    Subject claim;
    claim.name = summary.name + (has_friction ? "-coulomb" : "") + (setting.configured ? "" : "-as-shipped");
    claim.summary = summary.engine + ": " + (setting.configured ? summary.configured : "the engine's defaults");
    claim.summary += has_friction ? "; " + summary.friction : setting.configured ? "; fails on slender bodies" : "";
    claim.expected_to_pass = false;
    claim.model = setting.model;
    claim.precision = precision;
    claims.push_back(claim);
  }
  return claims;
}

[[nodiscard]] inline std::vector<Subject> bullet_claims() {
  return engine_claims({"bullet-double", "Bullet's sequential impulses",
                        "restitution threshold 0, no gyroscopic torque", "friction along the slip before the impulse"},
                       Precision::binary64);
}

[[nodiscard]] inline std::vector<Subject> ode_claims() {
  return engine_claims({"ode-double", "ODE's dWorldStep", "CFM 0, no gyroscopic torque, step 1/60 s",
                        "friction in a box of a width that the frictionless impulse says"},
                       Precision::binary64);
}

/// The claims of an engine that this program was built without.
[[nodiscard]] inline std::vector<Subject> absent(std::vector<Subject> claims, const std::string& package) {
  for (Subject& claim : claims) {
    claim.absent = package + " was not found when this program was built";
  }
  return claims;
}

}  // namespace carom::subjects
