// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>

#include <carom/report/results/comparison.hpp>

namespace carom::report {

[[nodiscard]] nlohmann::json comparison_record(const Comparison& comparison);

/// The field `baseline` of report.json.
[[nodiscard]] nlohmann::json baseline_record(const Comparison& comparison);

}  // namespace carom::report
