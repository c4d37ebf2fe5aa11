// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <pugixml.hpp>

#include "compare/comparison.hpp"

namespace carom::tool::compare {

/// What is new, fixed and known, and in what the runs are not comparable, appended to a section of a page.
void add_comparison(pugi::xml_node section, const Comparison& comparison);

/// A page of its own: well-formed XML as well, neither script nor network.
[[nodiscard]] std::string comparison_html(const Comparison& comparison);

}  // namespace carom::tool::compare
