// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <pugixml.hpp>

/// The content of a page. It is written as text for a terminal, as Markdown or as HTML. Texts may come from others:
/// each way of writing makes them safe.
namespace carom::report {

struct Block;
using Document = std::vector<Block>;

/// `look` is a class of the style sheet, for HTML alone, here and below.
struct Paragraph {
  std::string text;
  std::string look = {};
  bool is_strong = false;
};

/// Lines that stay as they are.
struct Code {
  std::string text;
};

struct Column {
  std::string name;
  bool is_number = false;   // stands at the right
  bool is_upright = false;  // in HTML the name is turned
};

struct Cell {
  Cell(std::string content = {}, std::string of_look = {}) : text(std::move(content)), look(std::move(of_look)) {}
  Cell(const char* content) : text(content) {}

  std::string text;
  std::string look;
  bool is_code = false;  // in Markdown: a name that others chose, in which nothing is read as markup or as a person
  // For HTML alone:
  std::string link = {};    // of the text, "#anchor"
  std::string sign = {};    // before the text, for those who see it;
  std::string spoken = {};  // and for those who hear it
  std::string before = {};  // before the link
  std::string small = {};   // below the text
};

struct List {
  std::vector<Cell> items;
};

/// Names and values; those without a value are left out.
struct Facts {
  std::vector<std::pair<std::string, Cell>> pairs;
};

struct Row {
  std::vector<Cell> cells;              // the first one is the row's name; the last one takes what columns are left
  std::vector<std::string> notes = {};  // lines below it, in a text
  bool is_group = false;                // the one cell is the heading of the rows below it
};

struct Table {
  std::string caption;  // HTML alone shows it
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::string look = "coverage";
};

/// For HTML alone: draws itself into an element.
struct Picture {
  std::function<void(pugi::xml_node)> draw;
};

struct Section {
  std::string title;
  Document content;
  std::string anchor = {};
  std::string element = "section";
  std::string look = {};
  bool is_code = false;  // its title, as of a cell
};

/// A name that others chose.
[[nodiscard]] inline Cell name_cell(std::string name) {
  Cell cell(std::move(name));
  cell.is_code = true;
  return cell;
}

/// A part that HTML shows on demand, and no other form shows.
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
  Block(T block) : is(std::move(block)) {}  // any of these stands for itself
};

/// Both, one after the other.
[[nodiscard]] Document with(Document first, Document second);

/// For a terminal. Tables have columns as wide as their longest cell.
[[nodiscard]] std::string in_text(const Document& document);

/// `level`: of the headings.
[[nodiscard]] std::string in_markdown(const Document& document, int level = 2);

/// Appends it to an element; `level` as above.
void add_html(pugi::xml_node parent, const Document& document, int level = 2);

/// A page by itself, HTML and well-formed XML, that neither loads nor runs anything.
struct Page {
  std::string title;
  std::string heading;
  std::vector<std::pair<std::string, std::string>> contents = {};  // anchors and what they lead to
  Document main;
  std::string footer = {};
};
[[nodiscard]] std::string html_page(const Page& page);

}  // namespace carom::report
