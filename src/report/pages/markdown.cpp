// SPDX-License-Identifier: BSL-1.0
#include <cctype>
#include <limits>
#include <string_view>

#include <carom/collision/json/text.hpp>
#include <carom/report/pages/document.hpp>

namespace carom::report {
namespace {

constexpr std::size_t longest_line = 4000;

bool is_in_word(const std::string& line, std::size_t at) {
  const auto is_word = [](char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0; };
  return at > 0 && at + 1 < line.size() && is_word(line[at - 1]) && is_word(line[at + 1]);
}

/// Escapes a line, so that it contains no markup and does not end the cell of a table. Within a word, _ is no markup. A
/// bracket is markup only if the next letter makes a link or a link definition.
std::string escaped(const std::string& text) {
  constexpr std::string_view markup = "\\`*|~";
  constexpr std::string_view makes_a_link = "([:";
  const std::string line = printable_line(text, longest_line);
  std::string result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char letter = line[i];
    const bool is_link =
        letter == ']' && i + 1 < line.size() && makes_a_link.find(line[i + 1]) != std::string_view::npos;
    if (letter == '<') {
      result += "&lt;";
    } else if (letter == '&') {
      result += "&amp;";
    } else {
      const bool is_markup =
          markup.find(letter) != std::string_view::npos || is_link || (letter == '_' && !is_in_word(line, i));
      result += (is_markup ? "\\" : "") + std::string(1, letter);
    }
  }
  return result;
}

std::string in_code(const std::string& text) {
  std::string code;
  for (const char letter : printable_line(text, longest_line)) {
    code += letter == '|' ? "\\|" : std::string(1, letter == '`' ? '\'' : letter);
  }
  return '`' + code + '`';
}

std::string cell_text(const Cell& cell) { return cell.is_code ? in_code(cell.text) : escaped(cell.text); }

/// Also escapes a first letter that would make the paragraph a heading or a list.
std::string paragraph_text(const std::string& text) {
  const std::string line = escaped(text);
  return (!line.empty() && std::string_view("#+-=>").find(line.front()) != std::string_view::npos ? "\\" : "") + line;
}

struct MarkdownWriter {
  int level;
  std::string text = {};

  /// Starts a block: an empty line separates blocks.
  void part() { text += text.empty() ? "" : "\n"; }

  void operator()(const Paragraph& paragraph) {
    part();
    const std::string line = paragraph_text(paragraph.text);
    text += (paragraph.is_strong ? "**" + line + "**" : line) + '\n';
  }

  void operator()(const List& list) {
    part();
    for (const Cell& item : list.items) {
      text += "- " + cell_text(item) + '\n';
    }
  }

  /// Indents each line. No text can end a code block made by indentation.
  void operator()(const Code& code) {
    part();
    bool begins = true;
    for (const char letter : printable(code.text, std::numeric_limits<std::size_t>::max())) {
      text += begins ? "    " : "";
      text += letter;
      begins = letter == '\n';
    }
    text += begins ? "" : "\n";
  }

  void operator()(const Facts& facts) {
    List list;
    for (const auto& [name, value] : facts.pairs) {
      if (!value.text.empty()) {
        list.items.push_back(name + ": " + value.text);
      }
    }
    (*this)(list);
  }

  void operator()(const Table& table) {
    part();
    text += "|";
    for (const Column& column : table.columns) {
      text += ' ' + escaped(column.name) + (column.name.empty() ? "|" : " |");
    }
    text += "\n|";
    for (const Column& column : table.columns) {
      text += column.is_number ? " ---: |" : " --- |";
    }
    text += '\n';
    for (const Row& row : table.rows) {
      text += "|";
      for (const Cell& cell : row.cells) {
        text += ' ' + cell_text(cell) + " |";
      }
      for (std::size_t i = row.cells.size(); i < table.columns.size(); ++i) {
        text += " |";
      }
      text += '\n';
    }
  }

  void operator()(const Picture& /*picture*/) {}

  void operator()(const Section& section) {
    part();
    if (!section.title.empty()) {
      text += std::string(static_cast<std::size_t>(level), '#') + ' ' +
              (section.is_code ? in_code(section.title) : escaped(section.title)) + "\n\n";
    }
    text += in_markdown(section.content, level + 1);
  }

  void operator()(const Details& /*details*/) {}

  void operator()(const Box& box) {
    part();
    text += in_markdown(box.content, level);
  }
};

}  // namespace

std::string in_markdown(const Document& document, int level) {
  MarkdownWriter writer{level};
  for (const Block& block : document) {
    std::visit(writer, block.is);
  }
  return std::move(writer.text);
}

}  // namespace carom::report
