// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>

namespace carom::tool {

/// A file of any kind, including a pipe or an endless device. The object keeps only as many bytes as the caller asks
/// for. Errors are UsageErrors that name the file.
class BoundedInput {
 public:
  /// Throws if the file cannot be opened or is a directory.
  BoundedInput(std::string file, std::stop_token stop);
  ~BoundedInput();
  BoundedInput(const BoundedInput&) = delete;
  BoundedInput& operator=(const BoundedInput&) = delete;

  /// The reason why a read ended. The end of a line is consumed, but not added to the text.
  enum class End { line, file, limit };

  /// Appends to the text up to the end of the line, or until the text has more than `most_bytes` bytes. Throws if the
  /// file cannot be read, or if the user asks for a stop while the function waits.
  End add_line(std::string& text, std::size_t most_bytes);

  /// Appends to the text up to the end of the file, or until the text has more than `most_bytes` bytes. Throws like
  /// add_line.
  End add_all(std::string& text, std::size_t most_bytes);

 private:
  /// Whether there is more to read. Postcondition: if there is, next_ < buffer_.size().
  bool fill();

  std::string file_;
  std::stop_token stop_;
  int descriptor_ = -1;
  std::string buffer_;
  std::size_t next_ = 0;  // in the buffer
};

}  // namespace carom::tool
