// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <ostream>
#include <span>
#include <string_view>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::mutants {

/// A defect that breaks one of the three properties and nothing else. Its subject claims `any`, so there is no truth to
/// compare with, and no backward error.
struct BrokenProperty {
  std::string_view name;
  std::string_view property;               // by its key (properties/three_properties.hpp)
  std::string_view sentence;               // what is wrong
  std::vector<std::string_view> violates;  // these invariants, and no others
  Subject (*subject)();
};

/// How GoogleTest prints it.
inline void PrintTo(const BrokenProperty& defect, std::ostream* out) { *out << defect.name << ": " << defect.sentence; }

[[nodiscard]] std::span<const BrokenProperty> broken_properties();

/// The solvers that the defects are planted in, without a defect.
[[nodiscard]] std::vector<Subject> unbroken_subjects();

}  // namespace carom::mutants
