// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <pugixml.hpp>

/// What every page of a report has.
namespace carom::tool {

using Fact = std::pair<std::string, std::string>;

/// A list of names and values, without those that are empty.
void add_facts(pugi::xml_node section, const std::vector<Fact>& facts);

/// Title, style, and a policy by which the page loads and runs nothing.
void add_head(pugi::xml_node html, const std::string& title);

/// The page as text that is HTML and well-formed XML.
[[nodiscard]] std::string serialized(const pugi::xml_document& document);

}  // namespace carom::tool
