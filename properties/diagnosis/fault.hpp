// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string>

#include <carom/properties/diagnosis/known_case.hpp>

namespace carom::properties::diagnosis {

struct Fault {
  std::string what;
  std::string look_at;
};

/// The step of mechanics at which most outcomes fail: a change without a cause, the reaction, the angular velocities,
/// or the impulse itself. An outcome counts for the first step that it fails. Preconditions: there is a case; the
/// answers are outcomes of finite numbers to valid collisions.
[[nodiscard]] Fault fault_of(std::span<const ViolatedCase> cases, Law law);

}  // namespace carom::properties::diagnosis
