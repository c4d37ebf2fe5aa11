// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

namespace carom::tool {

/// The page that src/tool/replay/bundle.mjs makes, with {{title}} and {{replay}} where these belong; empty where the
/// program was built without it.
[[nodiscard]] std::string_view replay_page();

}  // namespace carom::tool
