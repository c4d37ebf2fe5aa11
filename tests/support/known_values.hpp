// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

/// Numbers recorded in a file beside a test.
namespace carom::unit {

/// A name without a line break, and numbers.
struct KnownLine {
  std::string name;
  std::vector<double> numbers;
};

/// Expects the lines of the file: the same names, and numbers that agree to five digits. If one differs, writes the
/// actual lines to the directory of temporary files, and the failure names the file.
void expect_known_lines(const std::string& file, const std::vector<KnownLine>& lines);

}  // namespace carom::unit
