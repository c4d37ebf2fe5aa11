// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>

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

}  // namespace carom::tool
