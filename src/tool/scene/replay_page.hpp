// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

namespace carom::tool {

/// The page that src/tool/replay/bundle.mjs makes, with the marks {{title}} and {{replay}}; empty in a build without
/// the page.
[[nodiscard]] std::string_view replay_page();

}  // namespace carom::tool
