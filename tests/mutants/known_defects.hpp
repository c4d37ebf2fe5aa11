// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue.hpp"

namespace carom::mutants {

/// A limit in the code of a defect, as a diagnosis states it.
struct PlantedLimit {
  std::string_view before;  // the words before the number: "speed of approach |N·V⁻|/‖N‖ [m/s] is at most "
  double value;
};

/// A row of the table in docs/reference/diagnoses.md.
struct KnownDefect {
  const Mutant* mutant;
  std::string says;  // parts of the diagnosis, separated by …; the diagnosis contains them in this order
  std::optional<PlantedLimit> limit;
};

/// The rows of the page, "| `MUTANT`: SENTENCE | SAYS |". Throws std::invalid_argument if there is no such mutant.
[[nodiscard]] std::vector<KnownDefect> known_defects();

/// The first part of `says` that the text does not contain in order; empty if it contains all.
[[nodiscard]] std::string missing_part(const std::string& text, const std::string& says);

/// Whether the text says what the row says, with a limit within 10 % of the planted one.
[[nodiscard]] bool is_named_in(const std::string& text, const KnownDefect& defect);

}  // namespace carom::mutants
