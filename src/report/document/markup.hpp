// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include <pugixml.hpp>

/// Elements of XML and HTML. What stands in them is escaped by the library that writes them; here it is made what both
/// can hold at all.
namespace carom::report {

/// The text without what XML or HTML has no place for, escaped or not: control characters but line ends and tabs,
/// noncharacters, invalid UTF-8.
[[nodiscard]] std::string printable_text(std::string_view text);

using Attributes = std::initializer_list<std::pair<const char*, std::string_view>>;

/// Appends <name attributes>text</name>.
pugi::xml_node add(pugi::xml_node parent, const char* name, Attributes attributes = {}, std::string_view text = {});

/// Appends text.
void add_text(pugi::xml_node parent, std::string_view text);

}  // namespace carom::report
