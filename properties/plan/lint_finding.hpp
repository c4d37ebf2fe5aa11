// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <carom/collision/enum_array.hpp>

namespace carom::properties::plan {

/// What a lint finds.
enum class Lint {
  condition,          // K exceeds 16 λ
  lever_arm,          // of one body: [r]ᵀ J⁻¹ [r] exceeds 15/m
  moments,            // a principal moment exceeds the sum of the others
  centre_of_mass,     // of one body: beyond the plane at P across N, so outside of a convex body
  normal_length,      // far from 1
  quaternion_length,  // far from 1
  coefficient,        // ε, μ or e_t out of range, or beyond what is measured
  mass_ratio,
};
inline constexpr std::array all_lints{Lint::condition,      Lint::lever_arm,     Lint::moments,
                                      Lint::centre_of_mass, Lint::normal_length, Lint::quaternion_length,
                                      Lint::coefficient,    Lint::mass_ratio};
static_assert(counts_from_zero_to(all_lints, Lint::mass_ratio));

[[nodiscard]] constexpr std::string_view name_of(Lint lint) {
  switch (lint) {
    case Lint::condition:
      return "condition";
    case Lint::lever_arm:
      return "lever_arm";
    case Lint::moments:
      return "moments";
    case Lint::centre_of_mass:
      return "centre_of_mass";
    case Lint::normal_length:
      return "normal_length";
    case Lint::quaternion_length:
      return "quaternion_length";
    case Lint::coefficient:
      return "coefficient";
    case Lint::mass_ratio:
      break;
  }
  return "mass_ratio";
}

/// A note is worth knowing; a warning is most likely a mistake.
enum class Severity { note, warning };

[[nodiscard]] constexpr std::string_view name_of(Severity severity) {
  return severity == Severity::note ? "note" : "warning";
}

struct LintFinding {
  Lint lint;
  Severity severity;
  std::string place;  // of the collision, "FILE:7"
  std::string field;  // "a.principal_inertia"
  std::string text;
};

}  // namespace carom::properties::plan
