// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <stop_token>
#include <string>

#include <carom/collision/expects.hpp>

namespace carom::tool {

/// A file of any kind, including a pipe or an endless device. Keeps only as many bytes as the caller asks for. All
/// errors are UsageErrors that name the file.
class BoundedInput {
 public:
  /// Throws if the file is a directory or cannot be opened.
  BoundedInput(std::string file, std::stop_token stop);
  ~BoundedInput();
  BoundedInput(const BoundedInput&) = delete;
  BoundedInput& operator=(const BoundedInput&) = delete;

  /// The reason why a read ended. The end of a line is consumed, but not added to the text.
  enum class End { line, file, limit };

  /// Appends to the text up to the end of the line, or until the text has more than `most_bytes` bytes. Throws if the
  /// file cannot be read, or if a stop is requested while the function waits.
  End add_line(std::string& text, std::size_t most_bytes);

  /// Like add_line, up to the end of the file.
  End add_all(std::string& text, std::size_t most_bytes);

 private:
  /// Returns whether there is more to read. If there is, next_ < buffer_.size().
  bool fill();

  std::string file_;
  std::stop_token stop_;
  int descriptor_ = -1;
  std::string buffer_;
  std::size_t next_ = 0;  // in the buffer
};

/// The longest line of JSON Lines, and the largest file that is read as a whole [bytes].
inline constexpr std::size_t longest_line = std::size_t{16} << 20;
inline constexpr std::size_t largest_whole = std::size_t{256} << 20;

/// A JSON file. It is JSON Lines, of any length, if its first non-blank line is a complete JSON text and another
/// non-blank line follows. Otherwise it is one JSON text. Errors are UsageErrors that name the file and, for JSON
/// Lines, the line.
class JsonFile {
 public:
  /// Reads until the form is known. Throws if the file cannot be read, or is a single text that is too large.
  explicit JsonFile(const std::string& file, const std::stop_token& stop = {});

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] bool is_lines() const { return is_lines_; }

  struct Line {
    std::size_t number;  // from 1
    std::string text;
  };
  /// The next line that is not blank; none at the end. Throws if the line cannot be read or is too long. Precondition:
  /// is_lines().
  [[nodiscard]] std::optional<Line> next_line();

  /// Precondition: !is_lines().
  [[nodiscard]] const std::string& whole() const {
    CAROM_EXPECTS(!is_lines_, file_);
    return whole_;
  }

 private:
  [[nodiscard]] std::optional<Line> next_line_of_input();

  std::string file_;
  BoundedInput input_;
  bool is_lines_ = false;
  std::deque<Line> read_;  // lines that were read ahead
  std::size_t number_ = 0;
  bool has_ended_ = false;
  std::string whole_;
};

/// The whole content of a file. Throws UsageError that names the file if it cannot be read or is too large.
[[nodiscard]] std::string content_of_file(const std::string& file, const std::stop_token& stop = {});

}  // namespace carom::tool
