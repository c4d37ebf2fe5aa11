// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/solved_outcome.hpp>
#include <carom/collision/subject.hpp>
#include <carom/impulse/contact.hpp>

namespace carom::mutants {

/// A subject with one planted defect, and the invariants that must reject it.
struct Mutant {
  std::string_view name;
  Law law;
  std::string_view failure_cases;  // entries of docs/reference/failure-cases.md; empty if there are none
  std::string_view sentence;       // describes the defect
  std::string_view rejected_by;    // at least these invariants, separated by spaces
  std::string_view defect = name;  // its name in mutable_solver.cpp
};

inline void PrintTo(const Mutant& mutant, std::ostream* out) { *out << mutant.name << ": " << mutant.sentence; }

[[nodiscard]] std::span<const Mutant> all_mutants();

/// Throws std::invalid_argument if there is none.
[[nodiscard]] const Mutant& mutant_named(std::string_view name);

/// The names in a text that spaces separate.
[[nodiscard]] std::vector<std::string_view> names_in(std::string_view text);

/// One solver for the laws, in binary64, with the planted defects. With none it is sound.
[[nodiscard]] Subject make_subject(std::string name, Law law, std::vector<std::string_view> defects);

[[nodiscard]] Subject subject_of(const Mutant& mutant);

/// A solver with a defect that breaks exactly one of the three properties. It claims the law `any`, so its outcomes
/// have neither a truth nor a backward error.
struct BrokenProperty {
  std::string_view name;
  std::string_view property;  // the key in properties/three_properties.hpp
  std::string_view violates;  // these invariants and no others, separated by spaces
  SolvedOutcome<double> (*solve)(const impulse::Contact<double>&);
};

inline void PrintTo(const BrokenProperty& defect, std::ostream* out) { *out << defect.name; }

[[nodiscard]] std::span<const BrokenProperty> broken_properties();

[[nodiscard]] Subject subject_of(const BrokenProperty& broken);

/// The solvers in which these defects are planted, without a defect.
[[nodiscard]] std::vector<Subject> unbroken_subjects();

}  // namespace carom::mutants
