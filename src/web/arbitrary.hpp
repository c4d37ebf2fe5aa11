// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>

namespace carom::web {

/// The requests `chosen` and `simpler` of src/web/README.md, for property tests that shrink. Both throw std::exception
/// that names the error.
[[nodiscard]] nlohmann::json chosen(const nlohmann::json& request);
[[nodiscard]] nlohmann::json simpler(const nlohmann::json& request);

}  // namespace carom::web
