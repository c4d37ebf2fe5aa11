// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <carom/properties/plan/plan.hpp>

namespace carom::tool::plan {

/// A plan, and the input that it was made from.
struct PlanRun {
  std::string file;
  properties::plan::Demand demand;
  properties::plan::Plan plan;
  int repetitions = 0;  // of each timing; 0 if nothing was timed

  /// 0 if a candidate serves every contact, otherwise 1.
  [[nodiscard]] int exit_status() const;
};

/// The record of docs/reference/schemas/plan.schema.json.
[[nodiscard]] nlohmann::json plan_record(const PlanRun& run);

}  // namespace carom::tool::plan
