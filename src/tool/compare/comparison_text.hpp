// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "compare/comparison.hpp"

namespace carom::tool::compare {

/// For a terminal: both runs, in what they are not comparable, what changed of each subject, and the sum as the last
/// line.
[[nodiscard]] std::string comparison_text(const Comparison& comparison);

/// After a run: in what it is not comparable to its baseline, what is new and fixed, and one line that says the sum.
[[nodiscard]] std::string baseline_text(const Comparison& comparison);

}  // namespace carom::tool::compare
