// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <carom/properties/diagnosis/known_case.hpp>

namespace carom::properties::diagnosis {

/// A case that shows a fault. `carom replay --family` draws it again.
struct FaultWitness {
  std::string family;
  std::uint64_t index = 0;  // of the case in its family
  std::string invariant;    // that the answer violates
};

struct Fault {
  std::string what;         // the fault in the answers
  std::string look_at;      // the places in a solver to check; empty if no place is likelier
  std::string where = {};   // the cases in which it happens; empty if nothing is known
  std::uint64_t cases = 0;  // examined sampled cases in which it happens
  std::optional<FaultWitness> witness = {};
};

/// The step of mechanics at which most outcomes fail: a change without a cause, the reaction, the angular velocities,
/// or the impulse itself. An outcome counts for the first step that it fails. Sets `what` and `look_at`. Preconditions:
/// there is a case; the answers are outcomes of finite numbers to valid collisions.
[[nodiscard]] Fault fault_of(std::span<const ViolatedCase> cases, Law law);

}  // namespace carom::properties::diagnosis
