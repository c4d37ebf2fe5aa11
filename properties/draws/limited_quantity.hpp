// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/collision/enum_array.hpp>

namespace carom::properties {

/// The quantities of a collision that a domain limits. docs/reference/domains.md gives the formula of each.
enum class LimitedQuantity {
  size,
  mass,
  mass_ratio,
  moment_ratio,
  size_ratio,
  speed,
  approach,
  spin,
  distance,
  restitution,
  friction,
  tangential_restitution,
};
inline constexpr std::array all_limited_quantities{
    LimitedQuantity::size,         LimitedQuantity::mass,       LimitedQuantity::mass_ratio,
    LimitedQuantity::moment_ratio, LimitedQuantity::size_ratio, LimitedQuantity::speed,
    LimitedQuantity::approach,     LimitedQuantity::spin,       LimitedQuantity::distance,
    LimitedQuantity::restitution,  LimitedQuantity::friction,   LimitedQuantity::tangential_restitution};
static_assert(counts_from_zero_to(all_limited_quantities, LimitedQuantity::tangential_restitution));

template <class T>
using PerLimitedQuantity = EnumArray<LimitedQuantity, T, all_limited_quantities.size()>;

}  // namespace carom::properties
