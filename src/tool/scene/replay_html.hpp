// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace carom::tool {

/// Whether the program contains the page of replays. A build adds this page if src/tool/replay has its npm packages.
[[nodiscard]] bool has_replay();

/// The replay of a scene as one page. It loads nothing, and runs only the script that it contains. `replay` has the
/// format of docs/reference/replay.md. No content of `replay` or `title` adds an element to the page. Bytes that are
/// not UTF-8 become U+FFFD. Throws std::logic_error if has_replay() is false.
[[nodiscard]] std::string replay_html(std::string_view title, const nlohmann::json& replay);

/// The page that src/tool/replay/bundle.mjs makes, with the marks {{title}} and {{replay}}; empty in a build without
/// the page.
[[nodiscard]] std::string_view replay_page();

}  // namespace carom::tool
