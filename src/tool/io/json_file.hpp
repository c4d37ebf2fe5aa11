// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include <carom/collision/expects.hpp>

namespace carom::tool {

class BoundedInput;

/// A JSON file. It is JSON Lines, of any length, if its first non-blank line is a complete JSON text and another
/// non-blank line follows. Otherwise it is one JSON text. Errors are UsageErrors that name the file and, for JSON
/// Lines, the line.
class JsonFile {
 public:
  /// Reads until the form is known. Throws if the file cannot be read, or is a single text that is too large.
  explicit JsonFile(const std::string& file, const std::stop_token& stop = {});
  ~JsonFile();
  JsonFile(const JsonFile&) = delete;
  JsonFile& operator=(const JsonFile&) = delete;

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
  std::unique_ptr<BoundedInput> input_;
  bool is_lines_ = false;
  std::deque<Line> read_;  // lines that were read ahead
  std::size_t number_ = 0;
  bool has_ended_ = false;
  std::string whole_;
};

/// The whole content of a file. Throws UsageError that names the file if it cannot be read or is too large.
[[nodiscard]] std::string content_of_file(const std::string& file, const std::stop_token& stop = {});

}  // namespace carom::tool
