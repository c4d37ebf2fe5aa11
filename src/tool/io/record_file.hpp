// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/collision/json/record.hpp>

namespace carom::tool {

/// A file of recorded collisions: JSON Lines, an array or one object, or CSV if its name ends with ".csv". JSON Lines
/// and CSV may have any length.
class RecordFile {
 public:
  /// Throws UsageError if the file cannot be read, or if no column of a CSV file is one of a record.
  RecordFile(const std::string& file, const std::stop_token& stop);
  ~RecordFile();
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  /// A record that is not parsed yet.
  struct Text {
    std::string place;  // "FILE:3" for a line, "FILE: element 3" for an element of an array
    std::string text;
  };
  /// The next record; none at the end. Throws UsageError that names the place if it cannot be read.
  [[nodiscard]] std::optional<Text> next();

  /// The record as JSON, with its numbers as text if `spelled`. Any thread may call it. Throws FormatError.
  [[nodiscard]] nlohmann::json parsed(const Text& record, bool spelled) const;

 private:
  class Source;
  std::unique_ptr<Source> source_;
};

}  // namespace carom::tool
