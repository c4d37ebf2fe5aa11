// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <ostream>
#include <span>
#include <string_view>
#include <vector>

#include <carom/collision/subject.hpp>

#include "defect.hpp"

namespace carom::mutants {

/// A subject with one planted defect, and the invariants that must reject it.
struct Mutant {
  std::string_view name;
  Defect defect;
  Law law;
  std::string_view failure_cases;             // entries of docs/reference/failure-cases.md; empty if there are none
  std::string_view sentence;                  // describes the defect
  std::vector<std::string_view> rejected_by;  // at least these
};

inline void PrintTo(const Mutant& mutant, std::ostream* out) { *out << mutant.name << ": " << mutant.sentence; }

[[nodiscard]] std::span<const Mutant> all_mutants();

[[nodiscard]] Subject subject_of(const Mutant& mutant);

/// The subject of the mutant, without the defect.
[[nodiscard]] Subject repaired(const Mutant& mutant);

}  // namespace carom::mutants
