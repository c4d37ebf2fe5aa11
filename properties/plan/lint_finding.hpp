// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <carom/collision/enum_array.hpp>

namespace carom::properties::plan {

enum class Lint {
  condition,          // K exceeds 16 λ
  lever_arm,          // [r]ᵀ J⁻¹ [r] of one body exceeds 15/m
  moments,            // a principal moment exceeds the sum of the others
  centre_of_mass,     // a centre of mass lies on the other body's side of the plane at P across N
  normal_length,      // far from 1
  quaternion_length,  // far from 1
  coefficient,        // ε, μ or e_t is out of range, or μ beyond measured values
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

/// A note is worth knowing. A warning is most likely a mistake.
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
