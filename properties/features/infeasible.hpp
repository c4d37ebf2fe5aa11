// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <carom/properties/features/feature.hpp>

namespace carom::properties {

/// Why no colliding contact of real bodies has both features; empty where one can have them.
[[nodiscard]] std::string_view why_infeasible(const Feature& x, const Feature& y);

}  // namespace carom::properties
