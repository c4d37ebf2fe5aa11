// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include <carom/collision/enum_array.hpp>

namespace carom {

/// A change of the law's answer that a subject makes on purpose, and declares. docs/reference/protocol.md gives the
/// formula of each.
enum class DeclaredEffect {
  restitution_threshold,  // [m/s] a slower approach has ε = 0
  slop,                   // [m/s] a slower approach has no impulse
  linear_damping,         // fraction of each velocity that is lost
  angular_damping,        // fraction of each angular velocity that is lost
  max_speed,              // [m/s] longer velocities are shortened to this length
  max_angular_velocity,   // [rad/s] longer angular velocities are shortened to this length
};
inline constexpr std::array all_declared_effects{
    DeclaredEffect::restitution_threshold, DeclaredEffect::slop,      DeclaredEffect::linear_damping,
    DeclaredEffect::angular_damping,       DeclaredEffect::max_speed, DeclaredEffect::max_angular_velocity};
static_assert(counts_from_zero_to(all_declared_effects, DeclaredEffect::max_angular_velocity));

/// The size of each effect. 0 stands for an effect that is not declared.
using DeclaredEffects = EnumArray<DeclaredEffect, double, all_declared_effects.size()>;

[[nodiscard]] constexpr std::string_view name_of(DeclaredEffect effect) {
  constexpr EnumArray<DeclaredEffect, std::string_view, all_declared_effects.size()> names{
      "restitution_threshold", "slop", "linear_damping", "angular_damping", "max_speed", "max_angular_velocity"};
  return names[effect];
}

/// None if no effect has this name.
[[nodiscard]] constexpr std::optional<DeclaredEffect> declared_effect_named(std::string_view name) {
  for (const DeclaredEffect effect : all_declared_effects) {
    if (name_of(effect) == name) {
      return effect;
    }
  }
  return std::nullopt;
}

/// "m/s", "rad/s", or "" for a fraction.
[[nodiscard]] constexpr std::string_view unit_of(DeclaredEffect effect) {
  switch (effect) {
    case DeclaredEffect::linear_damping:
    case DeclaredEffect::angular_damping:
      return "";
    case DeclaredEffect::max_angular_velocity:
      return "rad/s";
    default:
      return "m/s";
  }
}

/// Whether the size is positive and finite, and less than 1 if it is a fraction.
[[nodiscard]] constexpr bool is_valid_size(DeclaredEffect effect, double size) {
  const double largest = unit_of(effect).empty() ? 1 : std::numeric_limits<double>::infinity();
  return size > 0 && size < largest;
}

}  // namespace carom
