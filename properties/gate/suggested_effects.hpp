// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

/// The effects that the violated sampled cases suggest, each with the size of fewest digits that fits them:
///
/// - restitution_threshold: all slower approaches with ε > 0 stop, and no faster one is violated.
/// - slop: all slower approaches keep their velocities, and no faster one is violated.
/// - linear_damping, angular_damping: contacts that do not collide lose the same fraction.
/// - max_speed, max_angular_velocity: many answers have the same greatest length.
///
/// An effect that the subject already declares is not suggested. The other sizes are 0. They are guesses: only a run
/// of the gate shows whether they explain the violations.
[[nodiscard]] DeclaredEffects suggested_effects(const SubjectResult& result, const GateReport& report);

}  // namespace carom::properties
