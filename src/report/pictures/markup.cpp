// SPDX-License-Identifier: BSL-1.0
#include <limits>

#include <carom/collision/json/text.hpp>
#include <carom/report/pictures/markup.hpp>

namespace carom::report {
namespace {

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

constexpr std::string_view replacement = "\xef\xbf\xbd";

}  // namespace

std::string printable_text(std::string_view text) {
  std::string result = carom::printable(std::string(text), std::numeric_limits<std::size_t>::max());
  // XML also excludes the noncharacters U+FFFE and U+FFFF.
  replace_all(result, "\xef\xbf\xbe", replacement);
  replace_all(result, "\xef\xbf\xbf", replacement);
  return result;
}

pugi::xml_node add(pugi::xml_node parent, const char* name, Attributes attributes, std::string_view text) {
  pugi::xml_node node = parent.append_child(name);
  for (const auto& [attribute, value] : attributes) {
    node.append_attribute(attribute) = printable_text(value).c_str();
  }
  add_text(node, text);
  return node;
}

void add_text(pugi::xml_node parent, std::string_view text) {
  if (!text.empty()) {
    parent.append_child(pugi::node_pcdata).set_value(printable_text(text).c_str());
  }
}

}  // namespace carom::report
