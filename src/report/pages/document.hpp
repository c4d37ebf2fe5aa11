// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <pugixml.hpp>

/// The content of a page. It can be written as text for a terminal or as HTML, and a table as Markdown. Each form
/// escapes the texts, which may come from third parties.
namespace carom::report {

struct Block;
using Document = std::vector<Block>;

/// In this file, `look` is a class of the style sheet. Only HTML uses it.
struct Paragraph {
  std::string text;
  std::string look = {};
};

/// Lines that are shown unchanged.
struct Code {
  std::string text;
};

struct Column {
  std::string name;
  bool is_number = false;   // aligned to the right
  bool is_upright = false;  // HTML turns the name upright
  bool is_in_text = true;   // a terminal has no room for each column
};

struct Cell {
  Cell(std::string content = {}, std::string of_look = {}) : text(std::move(content)), look(std::move(of_look)) {}
  Cell(const char* content) : text(content) {}

  std::string text;
  std::string look;
  bool is_code = false;   // Markdown shows it as code, so that a third party's name is neither markup nor an @mention.
                          // A text does not break it
  std::string link = {};  // the target of the text, "#anchor"
  std::string sign = {};  // a symbol before the text, not for screen readers
  std::string spoken = {};  // replaces the sign for screen readers
  std::string before = {};  // before the link
  std::string small = {};   // below the text
};

struct List {
  std::vector<Cell> items;
};

/// Names and values. Names without a value are left out.
struct Facts {
  std::vector<std::pair<std::string, Cell>> pairs;
};

struct Row {
  std::vector<Cell> cells;              // the first cell names the row; the last cell spans the remaining columns
  std::vector<std::string> notes = {};  // below the table, in a text; rows with the same note share it
  bool is_group = false;                // the only cell is the heading of the rows below
  std::string mark = {};                // a symbol before the row, in a text
};

struct Table {
  std::string caption;  // shown only in HTML
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::string look = "coverage";
};

/// Only for HTML: draws itself into an element.
struct Picture {
  std::function<void(pugi::xml_node)> draw;
};

struct Section {
  std::string title;
  Document content;
  std::string anchor = {};
  std::string element = "section";
  std::string look = {};
};

/// A name that a third party chose.
[[nodiscard]] inline Cell name_cell(std::string name) {
  Cell cell(std::move(name));
  cell.is_code = true;
  return cell;
}

/// Content that HTML shows on demand, and that no other form shows.
struct Details {
  std::string summary;
  Document content;
};

/// A part of a page with a look of its own.
struct Box {
  std::string look;
  Document content;
};

struct Block {
  std::variant<Paragraph, List, Code, Facts, Table, Picture, Section, Details, Box> is;

  template <class T>
  Block(T block) : is(std::move(block)) {}  // implicit, so that each alternative is a block
};

[[nodiscard]] Document with(Document first, Document second);

/// The document for a terminal. Lines end before `text_width`, except in tables and code. Each column of a table is as
/// wide as its longest cell. Each note of the rows stands once below the table, with the first cells of its rows.
[[nodiscard]] std::string in_text(const Document& document);

/// The number of characters in a line of a text.
inline constexpr std::size_t text_width = 100;

/// The text, broken at blanks into lines of at most `text_width` characters. `indent` begins each new line.
[[nodiscard]] std::string wrapped(const std::string& text, const std::string& indent);

/// The table as Markdown, without its notes.
[[nodiscard]] std::string markdown_table(const Table& table);

/// Appends the document to an element, with headings of this level.
void add_html(pugi::xml_node parent, const Document& document, int level = 2);

/// A whole page, as HTML and well-formed XML, that neither loads nor runs anything.
struct Page {
  std::string title;
  std::string heading;
  std::vector<std::pair<std::string, std::string>> contents = {};  // anchors, and the names of their targets
  Document main;
  std::string footer = {};
};
[[nodiscard]] std::string html_page(const Page& page);

/// The style sheet of every page, report.css. It must not contain <, > or &, because HTML does not unescape the content
/// of <style>.
extern const std::string_view report_style;

}  // namespace carom::report
