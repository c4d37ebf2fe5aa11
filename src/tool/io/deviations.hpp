// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::tool {

/// The texts of `--deviates`, "INVARIANT" or "INVARIANT@FAMILY", each once. Throws UsageError if one is no deviation.
[[nodiscard]] std::vector<std::string> known_deviations(const std::vector<std::string>& texts);

/// Adds these deviations (unclaimed invariants) to those of the subject.
void let_deviate(Subject& subject, const std::vector<std::string>& deviates);

}  // namespace carom::tool
