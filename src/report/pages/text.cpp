// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <limits>

#include <carom/collision/json/text.hpp>
#include <carom/report/pages/document.hpp>

namespace carom::report {
namespace {

constexpr std::size_t longest_cell = 4000;

/// The number of characters, not bytes.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

std::string cell_text(const Cell& cell) { return printable_line(cell.text, longest_cell); }

std::string lines_of(const std::string& text) { return printable(text, std::numeric_limits<std::size_t>::max()); }

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                 const std::vector<Column>& columns, std::string text = {}) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t width = width_of(cells[i]);
    const std::string room(widths[i] > width ? widths[i] - width : 0, ' ');
    text += (i == 0 ? "" : "  ") + (columns[i].is_number ? room + cells[i] : cells[i] + room);
  }
  return text.substr(0, text.find_last_not_of(' ') + 1) + '\n';
}

struct TextWriter {
  std::string text;

  void operator()(const Paragraph& paragraph) { text += wrapped(lines_of(paragraph.text), "") + '\n'; }

  void operator()(const List& list) {
    for (const Cell& item : list.items) {
      text += wrapped("  " + lines_of(item.text), "    ") + '\n';
    }
  }

  void operator()(const Code& code) {
    text += lines_of(code.text);
    text += code.text.ends_with('\n') ? "" : "\n";
  }

  void operator()(const Facts& facts) {
    for (const auto& [name, value] : facts.pairs) {
      const std::string fact = lines_of(name + ": " + value.text) + '\n';
      text += value.text.empty() ? "" : value.is_code ? fact : wrapped(fact, "  ");
    }
  }

  void operator()(const Table& table) {
    std::vector<Column> columns;
    std::vector<std::string> names;
    std::vector<std::size_t> widths;
    for (const Column& column : table.columns) {
      if (column.is_in_text) {
        columns.push_back(column);
        names.push_back(column.name);
        widths.push_back(width_of(column.name));
      }
    }
    std::vector<std::vector<std::string>> rows;
    for (const Row& row : table.rows) {
      std::vector<std::string>& cells = rows.emplace_back();
      for (std::size_t i = 0; i < row.cells.size(); ++i) {
        if (table.columns[i].is_in_text) {
          cells.push_back(cell_text(row.cells[i]));
        }
      }
      for (std::size_t i = 0; i < cells.size() && cells.size() == widths.size(); ++i) {
        widths[i] = std::max(widths[i], width_of(cells[i]));
      }
    }
    const auto is_marked = [](const Row& row) { return !row.mark.empty(); };
    const std::string no_mark = std::any_of(table.rows.begin(), table.rows.end(), is_marked) ? "  " : "";
    text += line(names, widths, columns, no_mark);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const Row& row = table.rows[r];
      text += (row.is_group ? "\n" : "") + line(rows[r], widths, columns, is_marked(row) ? row.mark + ' ' : no_mark);
    }
    add_notes(table);
  }

  void add_notes(const Table& table) {
    std::vector<std::pair<std::string, std::vector<std::string>>> notes;  // and their rows
    for (const Row& row : table.rows) {
      for (const std::string& note : row.notes) {
        const auto known = std::find_if(notes.begin(), notes.end(), [&](const auto& one) { return one.first == note; });
        auto& of_note = known == notes.end() ? notes.emplace_back(note, std::vector<std::string>{}) : *known;
        of_note.second.push_back(cell_text(row.cells[0]));
      }
    }
    constexpr std::size_t most_named = 4;
    for (const auto& [note, rows] : notes) {
      std::string names;
      for (std::size_t i = 0; i < std::min(rows.size(), most_named); ++i) {
        names += (i == 0 ? "  " : ", ") + rows[i];
      }
      names += rows.size() > most_named ? " and " + std::to_string(rows.size() - most_named) + " more" : "";
      const std::string whole = names + ": " + lines_of(note);
      const bool has_lines = note.find('\n') != std::string::npos;  // such as a request, which a reader may copy
      text += (has_lines ? whole : wrapped(whole, "    ")) + '\n';
    }
  }

  void operator()(const Picture& /*picture*/) {}

  void operator()(const Section& section) {
    text += text.empty() ? "" : "\n";
    text += section.title.empty() ? "" : lines_of(section.title) + '\n';
    text += in_text(section.content);
  }

  void operator()(const Details& /*details*/) {}

  void operator()(const Box& box) { text += in_text(box.content); }
};

}  // namespace

Document with(Document first, Document second) {
  for (Block& block : second) {
    first.push_back(std::move(block));
  }
  return first;
}

std::string wrapped(const std::string& text, const std::string& indent) {
  std::string result;
  std::size_t width = 0;  // of the current line
  bool has_word = false;  // whether the current line has one
  std::size_t begin = 0;  // of the current word
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (has_word && !word.empty() && width + width_of(word) > text_width) {
      result.replace(result.size() - 1, 1, '\n' + indent);
      width = width_of(indent);
    }
    has_word = has_word || !word.empty();
    result += word;
    width += width_of(word) + 1;
    if (end < text.size()) {
      result += text[end];
      if (text[end] == '\n') {
        width = 0;
        has_word = false;
      }
    }
    begin = end + 1;
  }
  return result;
}

std::string in_text(const Document& document) {
  TextWriter writer;
  for (const Block& block : document) {
    std::visit(writer, block.is);
  }
  return std::move(writer.text);
}

}  // namespace carom::report
