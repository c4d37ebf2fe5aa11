// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "compare/comparison.hpp"

namespace carom::tool::compare {

/// For a comment on a merge request: the sum, a table of what changed, a table of the subjects.
[[nodiscard]] std::string comparison_markdown(const Comparison& comparison);

}  // namespace carom::tool::compare
