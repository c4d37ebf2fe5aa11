// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include "compare/trend.hpp"

namespace carom::tool::compare {

/// A page of its own: well-formed XML as well, neither script nor network. `unread` says which reports could not be
/// read, and why.
[[nodiscard]] std::string trends_html(const Trends& trends, const std::vector<std::string>& unread);

}  // namespace carom::tool::compare
