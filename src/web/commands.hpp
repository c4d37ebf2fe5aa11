// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>

namespace carom::web {

/// The answer to a request. src/web/README.md lists the requests. Throws std::exception that names the error.
[[nodiscard]] nlohmann::json answer_to(const nlohmann::json& request);

/// The requests `chosen` and `simpler` of src/web/README.md, for property tests that shrink. Both throw std::exception
/// that names the error.
[[nodiscard]] nlohmann::json chosen(const nlohmann::json& request);
[[nodiscard]] nlohmann::json simpler(const nlohmann::json& request);

/// The requests `replay` and `judge` of src/web/README.md. Both throw std::exception that names the error.
[[nodiscard]] nlohmann::json replay(const nlohmann::json& request);
[[nodiscard]] nlohmann::json judge(const nlohmann::json& request);

}  // namespace carom::web
