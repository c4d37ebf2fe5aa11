// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <carom/collision/enum_array.hpp>

namespace carom::properties {

/// A change that a family makes to a case after drawing it. It does not depend on any solver.
enum class Adjustment {
  moments_enlarged,  // enlarged until the contact lies within twice the radius of gyration
  moved_to_origin,   // the contact is at the origin, so that parallel vectors are exactly parallel
  reversed,          // because the bodies separated
  drawn_again,       // because masses, sizes or speeds left the domain
};
inline constexpr std::array all_adjustments{Adjustment::moments_enlarged, Adjustment::moved_to_origin,
                                            Adjustment::reversed, Adjustment::drawn_again};
static_assert(counts_from_zero_to(all_adjustments, Adjustment::drawn_again));

template <class T>
using PerAdjustment = EnumArray<Adjustment, T, all_adjustments.size()>;

using AdjustmentCounts = PerAdjustment<std::uint64_t>;

[[nodiscard]] std::string_view name_of(Adjustment adjustment);

}  // namespace carom::properties
