// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <sstream>
#include <string_view>

#include <carom/report/pages/document.hpp>
#include <carom/report/pictures/markup.hpp>

namespace carom::report {
namespace {

pugi::xml_node add_with_look(pugi::xml_node parent, const char* name, const std::string& look,
                             std::string_view text = {}) {
  return look.empty() ? add(parent, name, {}, text) : add(parent, name, {{"class", look}}, text);
}

void add_cell_content(pugi::xml_node node, const Cell& cell) {
  add_text(node, cell.before);
  pugi::xml_node inside = cell.link.empty() ? node : add(node, "a", {{"href", cell.link}});
  if (!cell.sign.empty()) {
    add(inside, "span", {{"aria-hidden", "true"}, {"class", "sign"}}, cell.sign);
    if (!cell.spoken.empty()) {
      add(inside, "span", {{"class", "spoken"}}, cell.spoken + (cell.text.empty() ? "" : " "));
    }
  }
  add_text(inside, cell.text);
  if (!cell.small.empty()) {
    add(node, "small", {}, cell.small);
  }
}

void add_row(pugi::xml_node body, const Row& row, std::size_t columns) {
  if (row.is_group) {
    const pugi::xml_node heading = add(body, "tr", {{"class", "group"}});
    const pugi::xml_node cell = add(heading, "th", {{"scope", "rowgroup"}, {"colspan", std::to_string(columns)}});
    add(cell, "span", {}, row.cells.front().text);
    return;
  }
  const pugi::xml_node node = add(body, "tr");
  add_cell_content(add(node, "th", {{"scope", "row"}}), row.cells.front());
  for (std::size_t i = 1; i < row.cells.size(); ++i) {
    pugi::xml_node cell = add_with_look(node, "td", row.cells[i].look);
    if (i + 1 == row.cells.size() && i + 1 < columns) {
      cell.append_attribute("colspan") = std::to_string(columns - i).c_str();
    }
    add_cell_content(cell, row.cells[i]);
  }
}

struct HtmlWriter {
  pugi::xml_node parent;
  int level;

  void operator()(const Paragraph& paragraph) const { add_with_look(parent, "p", paragraph.look, paragraph.text); }

  void operator()(const List& list) const {
    const pugi::xml_node node = add(parent, "ul");
    for (const Cell& item : list.items) {
      add_cell_content(add(node, "li"), item);
    }
  }

  void operator()(const Code& code) const { add(parent, "pre", {{"tabindex", "0"}}, code.text); }

  void operator()(const Facts& facts) const {
    const pugi::xml_node list = add(parent, "dl");
    for (const auto& [name, value] : facts.pairs) {
      if (!value.text.empty()) {
        const pugi::xml_node pair = add(list, "div");
        add(pair, "dt", {}, name);
        add_cell_content(add(pair, "dd"), value);
      }
    }
  }

  void operator()(const Table& table) const {
    // A scrolling element must be reachable by the keyboard, so it also needs a label.
    const pugi::xml_node frame =
        add(parent, "div", {{"class", "scroll"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", table.caption}});
    const pugi::xml_node node = add(frame, "table", {{"class", table.look}});
    add(add(node, "caption"), "span", {}, table.caption);
    const auto is_named = [](const Column& column) { return !column.name.empty(); };
    if (std::any_of(table.columns.begin(), table.columns.end(), is_named)) {
      const pugi::xml_node head = add(add(node, "thead"), "tr");
      for (const Column& column : table.columns) {
        if (column.is_upright) {
          add(add(head, "th", {{"scope", "col"}, {"class", "upright"}}), "span", {}, column.name);
        } else {
          pugi::xml_node heading = add_with_look(head, "th", column.is_number ? "number" : "");
          heading.append_attribute("scope") = "col";
          add_text(heading, column.name);
        }
      }
    }
    pugi::xml_node body = add(node, "tbody");
    for (const Row& row : table.rows) {
      if (row.is_group && body.first_child()) {
        body = add(node, "tbody");
      }
      add_row(body, row, table.columns.size());
    }
  }

  void operator()(const Picture& picture) const { picture.draw(parent); }

  void operator()(const Section& section) const {
    pugi::xml_node node = add_with_look(parent, section.element.c_str(), section.look);
    const std::string tag = "h" + std::to_string(level);
    pugi::xml_node heading;
    if (!section.title.empty()) {
      heading = add(node, tag.c_str(), {}, section.title);
    }
    if (!section.anchor.empty()) {
      node.append_attribute("id") = section.anchor.c_str();
      node.append_attribute("aria-labelledby") = (section.anchor + "-heading").c_str();
      heading.append_attribute("id") = (section.anchor + "-heading").c_str();
    }
    add_html(node, section.content, level + 1);
  }

  void operator()(const Details& details) const {
    const pugi::xml_node node = add(parent, "details");
    add(node, "summary", {}, details.summary);
    add_html(node, details.content, level);
  }

  void operator()(const Box& box) const { add_html(add_with_look(parent, "div", box.look), box.content, level); }
};

void add_head(pugi::xml_node html, const std::string& title) {
  const pugi::xml_node head = add(html, "head");
  add(head, "meta", {{"charset", "utf-8"}});
  add(head, "meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  add(head, "meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  // This policy forbids the page to load or run anything, even if another page embeds it.
  add(head, "meta",
      {{"http-equiv", "Content-Security-Policy"},
       {"content", "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'"}});
  add(head, "title", {}, title);
  add(head, "style", {}, report_style);
}

/// HTML requires an end tag for every element without content, except for <meta/>.
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

}  // namespace

void add_html(pugi::xml_node parent, const Document& document, int level) {
  for (const Block& block : document) {
    std::visit(HtmlWriter{parent, level}, block.is);
  }
}

std::string html_page(const Page& page) {
  pugi::xml_document document;
  document.append_child(pugi::node_doctype).set_value("html");
  const pugi::xml_node html = add(document, "html", {{"lang", "en"}});
  add_head(html, page.title);
  const pugi::xml_node body = add(html, "body");
  if (!page.contents.empty()) {
    add(body, "a", {{"class", "skip"}, {"href", "#main"}}, "Skip to the report");
  }
  const pugi::xml_node header = add(body, "header");
  add(header, "h1", {}, page.heading);
  if (!page.contents.empty()) {
    const pugi::xml_node list = add(add(header, "nav", {{"aria-label", "Contents"}}), "ul");
    for (const auto& [anchor, name] : page.contents) {
      add(add(list, "li"), "a", {{"href", '#' + anchor}}, name);
    }
  }
  add_html(add(body, "main", {{"id", "main"}, {"tabindex", "-1"}}), page.main);
  if (!page.footer.empty()) {
    add(add(body, "footer"), "p", {}, page.footer);
  }
  return serialized(document) + '\n';
}

}  // namespace carom::report
