// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <carom/collision/subject.hpp>

namespace carom::subjects {

/// The law and the settings of an engine's subject.
struct EngineSetting {
  Law law;          // frictionless, or coulomb
  bool configured;  // false: the defaults of the engine, "as shipped"

  /// The arguments of a program that runs the engine.
  [[nodiscard]] std::vector<std::string> words() const {
    return {configured ? "configured" : "as-shipped", std::string(name_of(law))};
  }
};

/// The settings of an engine's subjects, in the order of the subjects.
inline constexpr std::array<EngineSetting, 4> engine_settings{
    {{Law::frictionless, true}, {Law::frictionless, false}, {Law::coulomb, true}, {Law::coulomb, false}}};

struct EngineSummary {
  std::string name;        // of the configured, frictionless subject; the other names begin with it
  std::string engine;      // the engine, and the part of it that is judged
  std::string configured;  // the settings of the configured subjects
  std::string friction;    // the engine's own friction law, which differs from `coulomb`
  DeclaredEffects as_shipped = {};
};

/// The subjects of an engine, before `open` or `absent` is set. No subject is expected to pass. Even the configured
/// subjects keep J⁻¹ in world coordinates, which fails on slender bodies, and their friction is not Coulomb's law.
[[nodiscard]] inline std::vector<Subject> engine_claims(const EngineSummary& summary, Precision precision) {
  std::vector<Subject> claims;
  for (const EngineSetting& setting : engine_settings) {
    const bool has_friction = setting.law == Law::coulomb;
    Subject claim;
    claim.name = summary.name + (has_friction ? "-coulomb" : "") + (setting.configured ? "" : "-as-shipped");
    claim.summary = summary.engine + ": " + (setting.configured ? summary.configured : "the engine's defaults");
    claim.summary += has_friction ? "; " + summary.friction : setting.configured ? "; fails on slender bodies" : "";
    claim.expected_to_pass = false;
    claim.law = setting.law;
    claim.precision = precision;
    claim.effects = setting.configured ? DeclaredEffects{} : summary.as_shipped;
    claims.push_back(claim);
  }
  return claims;
}

/// Bullet's default `m_restitutionVelocityThreshold`.
[[nodiscard]] inline DeclaredEffects bullet_as_shipped() {
  DeclaredEffects effects;
  effects[DeclaredEffect::restitution_threshold] = 0.2F;
  return effects;
}

[[nodiscard]] inline std::vector<Subject> bullet_claims() {
  return engine_claims(
      {"bullet-double", "Bullet's sequential impulses", "restitution threshold 0, no gyroscopic torque",
       "friction along the slip before the impulse", bullet_as_shipped()},
      Precision::binary64);
}

[[nodiscard]] inline std::vector<Subject> ode_claims() {
  return engine_claims({"ode-double", "ODE's dWorldStep", "CFM 0, no gyroscopic torque, step 1/60 s",
                        "friction in a box; the frictionless impulse determines its width"},
                       Precision::binary64);
}

/// The claims of an engine, if this program was built without the engine.
[[nodiscard]] inline std::vector<Subject> absent(std::vector<Subject> claims, const std::string& package) {
  for (Subject& claim : claims) {
    claim.absent = package + " was not found when this program was built";
  }
  return claims;
}

/// v/‖v‖ for any v ≠ 0, without overflow or underflow of the squared length.
template <int Size>
[[nodiscard]] Eigen::Matrix<double, Size, 1> unit(const Eigen::Matrix<double, Size, 1>& v) {
  return (v / v.cwiseAbs().maxCoeff()).normalized();
}

}  // namespace carom::subjects
