// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "compare/comparison.hpp"

namespace carom::tool::compare {

/// The text as what a cell of a Markdown table can hold: nothing in it ends the cell, or is read as markup.
[[nodiscard]] std::string markdown_cell(const std::string& text);

/// For a comment on a merge request: the sum, a table of what changed, a table of the subjects.
[[nodiscard]] std::string comparison_markdown(const Comparison& comparison);

}  // namespace carom::tool::compare
