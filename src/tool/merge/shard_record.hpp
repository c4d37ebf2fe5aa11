// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>

#include <carom/properties/gate/gate_result.hpp>

namespace carom::tool::merge {

/// What report.json says of a shard: which it is, and of each subject what a merge adds up and no other field has: its
/// correct digits by the bins of DigitsScale, and of each family in which it violates something, what was found there.
[[nodiscard]] nlohmann::json shard_record(const properties::GateReport& report);

}  // namespace carom::tool::merge
