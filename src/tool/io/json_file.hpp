// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <stop_token>
#include <string>

#include <carom/collision/expects.hpp>

#include "io/bounded_input.hpp"

namespace carom::tool {

/// The longest line of JSON Lines, and the largest file that is read as a whole [bytes].
inline constexpr std::size_t longest_line = std::size_t{16} << 20;
inline constexpr std::size_t largest_whole = std::size_t{256} << 20;

/// A file of JSON: JSON Lines, given line by line however many they are, where the first of several lines that are not
/// blank is a whole JSON text by itself; else one text. What it throws is a UsageError that names the file and, of a
/// line, its number.
class JsonFile {
 public:
  /// Reads as far as it takes to know which. Throws where the file cannot be read, or is no lines and too large.
  explicit JsonFile(const std::string& file, const std::stop_token& stop = {});

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] bool is_lines() const { return is_lines_; }

  struct Line {
    std::size_t number;  // from 1
    std::string text;
  };
  /// The next one that is not blank; none at the end. Precondition: they are lines. Throws where it cannot be read, or
  /// is too long.
  [[nodiscard]] std::optional<Line> next_line();

  /// Precondition: they are no lines.
  [[nodiscard]] const std::string& whole() const {
    CAROM_EXPECTS(!is_lines_, file_);
    return whole_;
  }

 private:
  [[nodiscard]] std::optional<Line> next_line_of_input();

  std::string file_;
  BoundedInput input_;
  bool is_lines_ = false;
  std::deque<Line> read_;  // ahead
  std::size_t number_ = 0;
  bool has_ended_ = false;
  std::string whole_;
};

/// The whole of a file, whatever it holds. Throws UsageError, which names it, where it cannot be read or is too large.
[[nodiscard]] std::string content_of_file(const std::string& file, const std::stop_token& stop = {});

}  // namespace carom::tool
