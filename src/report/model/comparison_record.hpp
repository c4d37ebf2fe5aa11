// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>

#include <carom/report/model/comparison.hpp>

namespace carom::report {

/// A comparison as JSON.
[[nodiscard]] nlohmann::json comparison_record(const Comparison& comparison);

/// What report.json says of the baseline.
[[nodiscard]] nlohmann::json baseline_record(const Comparison& comparison);

}  // namespace carom::report
