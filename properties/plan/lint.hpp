// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/collision/enum_array.hpp>
#include <carom/collision/validate.hpp>

namespace carom::properties::plan {

/// A collision that a plan must serve.
struct ClassedCollision {
  std::string contact_class;  // empty: `contact_class_of` names one
  Collision collision;
  std::string place = {};          // its source, "FILE:7", for messages
  bool is_normal_derived = false;  // from the bodies' positions, so its length is not a user's mistake
};

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
  constexpr EnumArray<Lint, std::string_view, all_lints.size()> names{
      "condition",     "lever_arm",         "moments",     "centre_of_mass",
      "normal_length", "quaternion_length", "coefficient", "mass_ratio"};
  return names[lint];
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

inline constexpr int largest_condition = 16;       // of K/λ, for uniform bodies star-shaped from the contact point
inline constexpr double length_noted = 0x1p-20;    // from here on, |length − 1| exceeds some ulps of binary32
inline constexpr double length_warned = 0x1p-10;   // from here on it is not rounding
inline constexpr double moments_noted = 0x1p-50;   // relative excess of a flat body's moments, rounded to binary64
inline constexpr double moments_warned = 0x1p-20;  // the same, rounded to binary32
inline constexpr double centre_of_mass_warned = 0x1p-20;  // more than the rounding of positions and N to binary32
inline constexpr double friction_noted = 5;               // greater than the measured values of solids
inline constexpr double mass_ratio_noted = 1e3;  // from here on, solvers of many contacts at once converge slowly
inline constexpr double mass_ratio_warned = 1e6;

/// Whether a collision is invalid only because ε, μ or e_t is finite but out of range. Then no law is defined.
[[nodiscard]] bool is_out_of_range(const Collision& collision);

/// The suspicious properties of a collision, decided exactly. Precondition: the collision is valid or
/// `is_out_of_range`.
[[nodiscard]] std::vector<LintFinding> findings_of(const ClassedCollision& contact);

}  // namespace carom::properties::plan
