// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <carom/properties/plan/plan.hpp>

namespace carom::tool::plan {

/// A plan, and what it was made of.
struct PlanRun {
  std::string file;
  properties::plan::Demand demand;
  properties::plan::Plan plan;
  int repetitions = 0;  // of each timing; 0 where nothing was timed

  /// 0 something serves every contact, 1 nothing does.
  [[nodiscard]] int exit_status() const;
};

/// As docs/reference/schemas/plan.schema.json has it.
[[nodiscard]] nlohmann::json plan_record(const PlanRun& run);

}  // namespace carom::tool::plan
