// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <pugixml.hpp>

namespace carom::report {

/// Appends a formula of the catalogue as MathML, so that a page shows it without any script. Reads as much of LaTeX as
/// the catalogue uses; what it does not know is left as it stands.
void add_formula(pugi::xml_node parent, std::string_view latex);

}  // namespace carom::report
