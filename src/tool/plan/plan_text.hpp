// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "plan/plan_record.hpp"

namespace carom::tool::plan {

/// The plan for a terminal: what serves each class and the whole, how to call it, what did not serve and why, and what
/// the lint found.
[[nodiscard]] std::string plan_text(const PlanRun& run);

/// The same tables in Markdown.
[[nodiscard]] std::string plan_markdown(const PlanRun& run);

}  // namespace carom::tool::plan
