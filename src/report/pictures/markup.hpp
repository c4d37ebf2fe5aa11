// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include <pugixml.hpp>

/// Elements of XML and HTML. pugixml escapes their content. These functions also replace characters that XML or HTML
/// cannot contain.
namespace carom::report {

/// The text without characters that XML or HTML cannot contain, even escaped: control characters except for line ends
/// and tabs, noncharacters, and invalid UTF-8.
[[nodiscard]] std::string printable_text(std::string_view text);

using Attributes = std::initializer_list<std::pair<const char*, std::string_view>>;

/// Appends <name attributes>text</name>.
pugi::xml_node add(pugi::xml_node parent, const char* name, Attributes attributes = {}, std::string_view text = {});

void add_text(pugi::xml_node parent, std::string_view text);

/// Appends a formula of the catalogue of invariants as MathML, so that a page shows it without a script. It reads the
/// part of LaTeX that the catalogue uses. An unknown command is shown unchanged.
void add_formula(pugi::xml_node parent, std::string_view latex);

}  // namespace carom::report
