// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <carom/collision/enum_array.hpp>

namespace carom::properties {

/// What a family changes of a case that it has drawn. No solver is asked for it.
enum class Adjustment {
  moments_enlarged,  // until the contact lies within twice the radius of gyration
  moved_to_origin,   // so that parallel vectors are parallel without rounding
  reversed,          // all velocities, since the bodies separated
  drawn_again,       // since masses, sizes or speeds left the domain
};
inline constexpr std::array all_adjustments{Adjustment::moments_enlarged, Adjustment::moved_to_origin,
                                            Adjustment::reversed, Adjustment::drawn_again};
static_assert(counts_from_zero_to(all_adjustments, Adjustment::drawn_again));

template <class T>
using PerAdjustment = EnumArray<Adjustment, T, all_adjustments.size()>;

/// How many cases were changed in each way.
using AdjustmentCounts = PerAdjustment<std::uint64_t>;

/// As reports name it: `moments_enlarged`, …
[[nodiscard]] std::string_view name_of(Adjustment adjustment);

}  // namespace carom::properties
