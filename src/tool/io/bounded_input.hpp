// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>

namespace carom::tool {

/// A file of any kind, a pipe or a device without end among them, of which no more is kept than asked for. What it
/// throws is a UsageError that names the file.
class BoundedInput {
 public:
  /// Throws where the file cannot be opened, or is a directory.
  BoundedInput(std::string file, std::stop_token stop);
  ~BoundedInput();
  BoundedInput(const BoundedInput&) = delete;
  BoundedInput& operator=(const BoundedInput&) = delete;

  /// What a read ended at. A line's end is taken from the file, and not added.
  enum class End { line, file, limit };

  /// Adds what follows to the text, up to the end of the line, or until the text has more than so many bytes. Throws
  /// where it cannot be read, or the user asks for a stop while it waits.
  End add_line(std::string& text, std::size_t most_bytes);

  /// The same up to the end of the file: no line is an end.
  End add_all(std::string& text, std::size_t most_bytes);

 private:
  /// Whether there is more. Postcondition: then next_ < buffer_.size().
  bool fill();

  std::string file_;
  std::stop_token stop_;
  int descriptor_ = -1;
  std::string buffer_;
  std::size_t next_ = 0;  // in the buffer
};

}  // namespace carom::tool
