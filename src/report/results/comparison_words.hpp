// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/report/results/comparison.hpp>

/// The words that all forms of a comparison share.
namespace carom::report {

/// The violated and judged cases: "12 of 1000"; for a violation in both reports with different counts, "12 of 1000 → 15
/// of 1000"; for a violation in the older report alone, "12 of 1000 before".
[[nodiscard]] std::string counts_in_short(const ComparedViolation& violation);

/// "Carom 0.1.0, 2026-11-23T18:00:00Z, seed 1, 1000 cases of each of 35 families".
[[nodiscard]] std::string run_in_words(const RunHeading& report);

/// "violated → sound", or one status if both are the same. "came: sound" or "went: violated" if only one report has it.
[[nodiscard]] std::string status_in_words(const ComparedSubject& subject);

/// A number of a subject before and now, if the shown texts differ.
struct ChangedNumber {
  std::string what;
  std::string before;
  std::string now;
};

/// The changes of version, law, precision, cases, violated cases, worst backward error with its family, and digits.
[[nodiscard]] std::vector<ChangedNumber> changed_numbers(const ComparedSubject& subject);

/// A setting that differs between the runs: "seed: 1 before, 2 now".
[[nodiscard]] std::string difference_in_words(const Difference& difference);

/// The text that explains what different settings mean for the comparison.
extern const char* const differences_mean;

}  // namespace carom::report
