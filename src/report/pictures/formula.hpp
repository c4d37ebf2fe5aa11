// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <pugixml.hpp>

namespace carom::report {

/// Appends a formula of the catalogue of invariants as MathML, so that a page shows it without a script. It reads the
/// part of LaTeX that the catalogue uses. An unknown command is shown unchanged.
void add_formula(pugi::xml_node parent, std::string_view latex);

}  // namespace carom::report
