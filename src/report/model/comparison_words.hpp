// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/report/model/comparison.hpp>

/// What all forms of a comparison say alike.
namespace carom::report {

/// "12 of 1000 cases, held in 1000 before", as fits the change.
[[nodiscard]] std::string counts_in_words(const ComparedViolation& violation);

/// The same where the change is said beside it: "12 of 1000", of what is known "12 of 1000 → 15 of 1000" where it
/// changed, of what is gone "12 of 1000 before".
[[nodiscard]] std::string counts_in_short(const ComparedViolation& violation);

/// "Carom 0.1.0, 2026-11-23T18:00:00Z, seed 1, 1000 cases of each of 35 families".
[[nodiscard]] std::string run_in_words(const RunHeading& report);

/// "violated → sound", or the one status that both have; "came: sound", "went: violated".
[[nodiscard]] std::string status_in_words(const ComparedSubject& subject);

/// A number of a subject before and now, where they differ in what is shown.
struct ChangedNumber {
  std::string what;
  std::string before;
  std::string now;
};

/// Version, cases, cases violated, worst backward error with its family, digits.
[[nodiscard]] std::vector<ChangedNumber> changed_numbers(const ComparedSubject& subject);

/// Of the settings in which the runs differ: "seed: 1 before, 2 now".
[[nodiscard]] std::string difference_in_words(const Difference& difference);

/// What it means that there are any.
extern const char* const differences_mean;

}  // namespace carom::report
