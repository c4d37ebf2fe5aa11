// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <carom/collision/enum_array.hpp>

namespace carom {

/// The law that a subject claims to follow.
enum class Law {
  frictionless,  // the impulse is along the normal (Eberly's note, eq. 18)
  reflection,    // the tangential velocity of the contact point is kept (Eberly's note, eq. 17, 20, 21)
  sticking,  // the contact point stops, except that its normal velocity rebounds: N·V⁺ = −ε N·V⁻, N × V⁺ = 0
  rough,     // Coulomb friction and a tangential restitution e_t (A. Chatterjee, A. Ruina 1998)
  coulomb,   // N·V⁺ = −ε N·V⁻; friction in its cone stops the slip or opposes the remaining slip
  any,       // no particular law: only the rules that hold for every law are judged
};

inline constexpr std::array all_laws{Law::frictionless, Law::reflection, Law::sticking,
                                     Law::rough,        Law::coulomb,    Law::any};
static_assert(counts_from_zero_to(all_laws, Law::any));

template <class T>
using PerLaw = EnumArray<Law, T, all_laws.size()>;

/// The laws that determine one outcome by a formula. The other laws are judged by their equations.
inline constexpr std::array laws_with_truth{Law::frictionless, Law::reflection, Law::sticking, Law::rough};

[[nodiscard]] constexpr bool determines_outcome(Law law) {
  return std::find(laws_with_truth.begin(), laws_with_truth.end(), law) != laws_with_truth.end();
}

[[nodiscard]] constexpr std::string_view name_of(Law law) {
  constexpr PerLaw<std::string_view> names{"frictionless", "reflection", "sticking", "rough", "coulomb", "any"};
  return names[law];
}

[[nodiscard]] constexpr std::optional<Law> law_named(std::string_view name) {
  for (const Law law : all_laws) {
    if (name_of(law) == name) {
      return law;
    }
  }
  return std::nullopt;
}

}  // namespace carom
