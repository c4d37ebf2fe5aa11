// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "report/records.hpp"

namespace carom::tool {

/// The run as workflow commands of GitHub, a line each: an error for each invariant that a subject violates and for
/// each subject that could not be judged, of those that count, then a notice with the verdict on all.
[[nodiscard]] std::string github_annotations(const GateRun& run, const std::string& out_directory);

}  // namespace carom::tool
