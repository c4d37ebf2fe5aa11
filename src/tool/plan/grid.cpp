// SPDX-License-Identifier: BSL-1.0
#include "plan/grid.hpp"

#include <algorithm>
#include <cstddef>

#include <carom/subjects/protocol/text.hpp>

namespace carom::tool::plan {
namespace {

/// Characters of UTF-8.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

constexpr std::size_t longest_cell = 400;

/// Cells hold names and places of files.
std::string one_line(const std::string& text) { return subjects::protocol::printable_line(text, longest_cell); }

/// Without what would end a cell.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : one_line(text)) {
    result += letter == '|' ? std::string("\\|") : std::string(1, letter);
  }
  return result;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += ' ' + escaped(cell) + " |";
  }
  return line + '\n';
}

}  // namespace

std::string grid_text(const Grid& grid) {
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < grid.heading.size(); ++column) {
    std::size_t width = width_of(grid.heading[column]);
    for (const auto& row : grid.rows) {
      width = std::max(width, width_of(one_line(row[column])));
    }
    widths.push_back(width);
  }
  std::string text;
  const auto write = [&](const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t column = 0; column < cells.size(); ++column) {
      const std::string cell = one_line(cells[column]);
      line += cell + std::string(widths[column] - width_of(cell) + 2, ' ');
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  };
  write(grid.heading);
  std::ranges::for_each(grid.rows, write);
  return text;
}

std::string grid_markdown(const Grid& grid) {
  std::string text = markdown_row(grid.heading);
  text += markdown_row(std::vector<std::string>(grid.heading.size(), "---"));
  for (const auto& row : grid.rows) {
    text += markdown_row(row);
  }
  return text;
}

}  // namespace carom::tool::plan
