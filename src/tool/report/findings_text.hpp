// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/records.hpp"

namespace carom::tool {

/// What is wrong with a subject that violates something, for a terminal: the diagnosis, the witness that tells most in
/// words, the others in a line each. `out_directory` is where witnesses are written; empty where they are not.
[[nodiscard]] std::string findings_text(const GateRun& run, std::size_t subject, const std::string& out_directory);

/// The witnesses of a subject, the one that tells most first.
[[nodiscard]] std::vector<const properties::Witness*> witnesses_by_telling(const GateRun& run, std::size_t subject);

}  // namespace carom::tool
