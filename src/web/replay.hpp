// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>

namespace carom::web {

/// The requests `replay` and `judge` of src/web/README.md. Both throw std::exception that names the error.
[[nodiscard]] nlohmann::json replay(const nlohmann::json& request);
[[nodiscard]] nlohmann::json judge(const nlohmann::json& request);

}  // namespace carom::web
