// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/replay_page.hpp"

namespace carom::tool {

std::string_view replay_page() { return {}; }

}  // namespace carom::tool
