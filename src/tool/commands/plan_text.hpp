// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "commands/plan_record.hpp"

namespace carom::tool::plan {

/// The plan for a terminal. It lists the candidates (built-in methods) that serve each class and all contacts, with
/// their C++ calls. It also lists the candidates that do not serve all contacts, with the reasons, and the findings of
/// the lint.
[[nodiscard]] std::string plan_text(const PlanRun& run);

/// The same tables in Markdown.
[[nodiscard]] std::string plan_markdown(const PlanRun& run);

}  // namespace carom::tool::plan
