// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <ostream>
#include <span>
#include <string_view>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::mutants {

/// A defect that breaks exactly one of the three properties. The subject claims the law `any`, so its outcomes have
/// neither a truth nor a backward error.
struct BrokenProperty {
  std::string_view name;
  std::string_view property;               // the key in properties/three_properties.hpp
  std::string_view sentence;               // describes the defect
  std::vector<std::string_view> violates;  // these invariants, and no others
  Subject (*subject)();
};

inline void PrintTo(const BrokenProperty& defect, std::ostream* out) { *out << defect.name << ": " << defect.sentence; }

[[nodiscard]] std::span<const BrokenProperty> broken_properties();

/// The solvers in which the defects are planted, without a defect.
[[nodiscard]] std::vector<Subject> unbroken_subjects();

}  // namespace carom::mutants
