// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>

#include "report/overall.hpp"

namespace carom::tool {

/// The verdict as shields.io's endpoint badge reads it (https://shields.io/badges/endpoint-badge).
[[nodiscard]] nlohmann::json badge_record(const Overall& overall);

}  // namespace carom::tool
