// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

namespace carom::tool::plan {

/// Rows of cells under a heading.
struct Grid {
  std::vector<std::string> heading;
  std::vector<std::vector<std::string>> rows;  // each as long as the heading
};

/// Columns as wide as their longest cell.
[[nodiscard]] std::string grid_text(const Grid& grid);

[[nodiscard]] std::string grid_markdown(const Grid& grid);

}  // namespace carom::tool::plan
