// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

namespace carom::unit {

/// A name without a line break, and numbers.
struct KnownLine {
  std::string name;
  std::vector<double> numbers;
};

/// Expects the names of the file, and its numbers to five digits. Otherwise writes the actual lines to a temporary file
/// that the failure names.
void expect_known_lines(const std::string& file, const std::vector<KnownLine>& lines);

}  // namespace carom::unit
