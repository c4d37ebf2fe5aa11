// SPDX-License-Identifier: BSL-1.0
#include "report/extent.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "commands/duration.hpp"

namespace carom::tool {

using properties::FamilyResult;

std::string extent_of(const properties::GateOptions& options) {
  const std::string extent =
      options.budget ? fmt::format("{} on {} families in turn", in_words(*options.budget), options.families.size())
                     : fmt::format("{} cases of each of {} families", options.cases, options.families.size());
  const std::string shard =
      options.shard.of > 1 ? fmt::format(", shard {} of {}", options.shard.number, options.shard.of) : "";
  return extent + shard + (options.fail_fast ? ", each subject to its first violation" : "");
}

std::string cases_judged(const properties::SubjectResult& result, const properties::GateOptions& options) {
  const auto fewest = std::min_element(result.families.begin(), result.families.end(),
                                       [](const FamilyResult& x, const FamilyResult& y) { return x.cases < y.cases; });
  const auto& family = *options.families[static_cast<std::size_t>(fewest - result.families.begin())];
  return fmt::format("judged on {} cases in {}, the fewest of them {} of {}", result.cases(), in_words(*options.budget),
                     fewest->cases, family.name);
}

}  // namespace carom::tool
