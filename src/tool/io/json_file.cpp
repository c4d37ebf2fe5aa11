// SPDX-License-Identifier: BSL-1.0
#include "io/json_file.hpp"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <carom/collision/expects.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

using End = BoundedInput::End;

constexpr std::size_t mebibyte = std::size_t{1} << 20;

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

void add_rest(BoundedInput& input, std::string& text, const std::string& file) {
  if (input.add_all(text, largest_whole) == End::limit) {
    throw UsageError(
        fmt::format("{}: the file is larger than {} MiB; write it as JSON Lines", file, largest_whole / mebibyte));
  }
}

}  // namespace

JsonFile::JsonFile(const std::string& file, const std::stop_token& stop) : file_(file), input_(file, stop) {
  std::string line;
  End end = End::line;
  while (end == End::line && is_blank(line) && whole_.size() <= longest_line) {
    whole_ += number_ > 0 ? line + '\n' : "";
    line.clear();
    ++number_;
    end = input_.add_line(line, longest_line);
  }
  if (end == End::line && !is_blank(line) && nlohmann::json::accept(line)) {
    read_.push_back({number_, line});
    if (std::optional<Line> second = next_line_of_input()) {
      read_.push_back(std::move(*second));
      is_lines_ = true;
      whole_.clear();
      return;
    }
    read_.clear();
  }
  whole_ += line + (end == End::line ? "\n" : "");
  add_rest(input_, whole_, file);
}

std::optional<JsonFile::Line> JsonFile::next_line_of_input() {
  while (!has_ended_) {
    Line line{++number_, {}};
    const End end = input_.add_line(line.text, longest_line);
    if (end == End::limit) {
      throw UsageError(fmt::format("{}:{}: the line is longer than {} MiB; write one collision per line", file_,
                                   line.number, longest_line / mebibyte));
    }
    has_ended_ = end == End::file;
    if (!is_blank(line.text)) {
      return line;
    }
  }
  return std::nullopt;
}

std::optional<JsonFile::Line> JsonFile::next_line() {
  CAROM_EXPECTS(is_lines_, file_);
  if (read_.empty()) {
    return next_line_of_input();
  }
  Line line = std::move(read_.front());
  read_.pop_front();
  return line;
}

std::string content_of_file(const std::string& file, const std::stop_token& stop) {
  BoundedInput input(file, stop);
  std::string text;
  add_rest(input, text, file);
  return text;
}

}  // namespace carom::tool
