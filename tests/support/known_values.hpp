// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

namespace carom::unit {

/// A line of the file. The name has no colon and no line break.
struct KnownLine {
  std::string name;
  std::vector<double> numbers;
};

/// Expects `lines` to equal the lines of the file, with numbers to five digits. If not, writes `lines` to a temporary
/// file that the failure names.
void expect_known_lines(const std::string& file, const std::vector<KnownLine>& lines);

}  // namespace carom::unit
