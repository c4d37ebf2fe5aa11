// SPDX-License-Identifier: BSL-1.0
#include "scene/replay_page.hpp"

namespace carom::tool {

std::string_view replay_page() { return {}; }

}  // namespace carom::tool
