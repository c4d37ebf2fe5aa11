// SPDX-License-Identifier: BSL-1.0
#include "report/page.hpp"

#include <sstream>
#include <string_view>

#include "report/markup.hpp"
#include "report/report_style.hpp"

namespace carom::tool {

void add_facts(pugi::xml_node section, const std::vector<Fact>& facts) {
  const pugi::xml_node list = add(section, "dl");
  for (const auto& [name, value] : facts) {
    if (!value.empty()) {
      const pugi::xml_node pair = add(list, "div");
      add(pair, "dt", {}, name);
      add(pair, "dd", {}, value);
    }
  }
}

void add_head(pugi::xml_node html, const std::string& title) {
  const pugi::xml_node head = add(html, "head");
  add(head, "meta", {{"charset", "utf-8"}});
  add(head, "meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  add(head, "meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  // No page that shows this one can make it load or run anything.
  add(head, "meta",
      {{"http-equiv", "Content-Security-Policy"},
       {"content", "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'"}});
  add(head, "title", {}, title);
  add(head, "style", {}, report_style);
}

/// In HTML an element without content has either no end tag or must have one; <meta/> is read the same as XML.
std::string serialized(const pugi::xml_document& document) {
  std::ostringstream stream;
  document.save(stream, "", pugi::format_raw | pugi::format_no_declaration | pugi::format_no_empty_element_tags);
  std::string text = stream.str();
  constexpr std::string_view end = "></meta>";
  for (std::size_t at = text.find(end); at != std::string::npos; at = text.find(end, at)) {
    text.replace(at, end.size(), "/>\n");
  }
  return text;
}

}  // namespace carom::tool
