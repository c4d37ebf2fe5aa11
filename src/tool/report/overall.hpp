// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>

#include "report/records.hpp"

namespace carom::tool {

/// What a run found, of the subjects that count.
struct Overall {
  std::size_t subjects = 0;
  std::size_t sound = 0;
  std::size_t violated = 0;    // invariants, each counted once for each subject that violates it
  std::size_t not_judged = 0;  // subjects, also those that could not be judged to the end
  bool interrupted = false;
};

[[nodiscard]] Overall overall_of(const GateRun& run);

/// The same of a report.json. Throws nlohmann::json::exception where it is none.
[[nodiscard]] Overall overall_of(const nlohmann::json& report);

/// "sound", "3 violated" or "not judged". What was found violated is said also where something was not judged.
[[nodiscard]] std::string in_words(const Overall& overall);

}  // namespace carom::tool
