// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace carom::tool {

/// The JSON of a report.json. Throws UsageError, which names the file, where it cannot be read or is no JSON.
[[nodiscard]] nlohmann::json report_from(const std::string& file);

}  // namespace carom::tool
