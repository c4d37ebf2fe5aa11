// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>

namespace carom::web {

/// The answer to a request. src/web/README.md lists the requests. Throws std::exception that names the error.
[[nodiscard]] nlohmann::json answer_to(const nlohmann::json& request);

}  // namespace carom::web
