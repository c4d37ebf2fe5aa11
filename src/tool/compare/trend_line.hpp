// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <pugixml.hpp>

namespace carom::tool::compare {

/// Appends a small drawing of the values from report to report, to the logarithm of 1 + value, from 0 at the bottom to
/// the largest at the top. What is infinite stands at the top; where there is none, the line is broken. `label` is what
/// those hear who do not see it.
void add_trend_line(pugi::xml_node parent, const std::string& label, const std::vector<std::optional<double>>& values);

}  // namespace carom::tool::compare
