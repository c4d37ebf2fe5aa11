// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <carom/report/results/run.hpp>

namespace carom::report {

/// The facts that are the same in all shards of a run, in words. Each has the name of its field.
using RunFacts = std::vector<std::pair<std::string, std::string>>;

[[nodiscard]] RunFacts run_facts(const Run& run);

struct FactDifference {
  std::string field;
  std::string first;
  std::string second;
};

/// The first field in which two runs differ; none if all facts agree.
[[nodiscard]] std::optional<FactDifference> first_difference(const RunFacts& first, const RunFacts& second);

}  // namespace carom::report
