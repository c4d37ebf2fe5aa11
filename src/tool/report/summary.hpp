// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "report/records.hpp"

namespace carom::tool {

/// The run as Markdown: the verdict, a table of the subjects that count, and of each that violates something the
/// invariants, the families, the first witness in words and how to replay it. Less than the mebibyte that GitHub takes:
/// where it would be more, subjects are shown without what they violate.
[[nodiscard]] std::string markdown_summary(const GateRun& run, const std::string& out_directory);

}  // namespace carom::tool
