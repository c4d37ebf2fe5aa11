// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <carom/properties/diagnosis/known_case.hpp>

namespace carom::properties::diagnosis {

/// A case that shows a fault. `carom replay --family` draws it again.
struct FaultWitness {
  const Family* family = nullptr;
  std::uint64_t index = 0;               // of the case in its family
  const Invariant* invariant = nullptr;  // that the answer violates
};

struct Fault {
  std::string what;         // the fault in the answers
  std::string look_at;      // the places in a solver to check; empty if no place is likelier
  std::string where = {};   // the cases in which it happens, as a clause (where.hpp); empty if nothing is known
  std::uint64_t cases = 0;  // examined sampled cases in which it happens
  std::optional<FaultWitness> witness = {};
};

/// The fault in one line, with its condition, and `look_at` in a second one, unless it is empty.
[[nodiscard]] std::vector<std::string> lines_of(const Fault& fault);

/// The lines of the faults, each after `indent`, and at most `most` lines.
[[nodiscard]] std::string in_words(std::span<const Fault> faults, const std::string& indent, std::size_t most);

/// The kinds of faults of the collision matrices that a subject shows.
enum class MatrixFault {
  missing,        // a contact that collides has none
  out_of_bounds,  // not positive definite, or too large
  another,        // not the matrix of the contact, or not the one that the outcome belongs to
};

/// The fault of a subject whose outcomes are right, and whose shown matrices are wrong.
[[nodiscard]] Fault fault_of_matrix(MatrixFault kind);

/// The fault of a subject that gives another answer if it is asked again.
[[nodiscard]] Fault fault_of_memory();

/// The step of mechanics at which most outcomes fail: a change without a cause, the reaction, the angular velocities,
/// or the impulse itself. An outcome counts for the first step that it fails. Sets `what` and `look_at`. Preconditions:
/// there is a case; the answers are outcomes of finite numbers to valid collisions.
[[nodiscard]] Fault fault_of(std::span<const ViolatedCase> cases, Law law);

}  // namespace carom::properties::diagnosis
