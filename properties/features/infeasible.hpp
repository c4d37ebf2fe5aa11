// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// The reason why no colliding contact of real bodies has both features; empty if some contact has both.
[[nodiscard]] std::string_view why_infeasible(const Feature& x, const Feature& y);

}  // namespace carom::properties
