// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace carom::tool {

/// Whether the program was built with the page of replays: src/tool/replay had its packages of npm then.
[[nodiscard]] bool has_replay();

/// A scene to look at: one page that needs nothing else and loads nothing, and runs the script that it contains alone.
/// `replay` is as docs/reference/replay.md says. Whatever stands in it and in `title`, it adds no element to the page;
/// what is no UTF-8 becomes U+FFFD.
/// Throws std::logic_error where has_replay() is false.
[[nodiscard]] std::string replay_html(std::string_view title, const nlohmann::json& replay);

}  // namespace carom::tool
