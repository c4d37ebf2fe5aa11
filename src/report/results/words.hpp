// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <carom/report/results/run.hpp>

/// Words that all forms of a report share.
namespace carom::report {

/// The greatest length of a line that a report quotes from elsewhere, in bytes.
inline constexpr std::size_t longest_line = 4000;

/// A third party's text, as one line that is safe to print.
[[nodiscard]] std::string shown(const std::string& text);

/// "32 ulps" or "8 digits".
[[nodiscard]] std::string limit_in_words(const oracles::Limits& limits);

/// " --within size=0.1:10", the option for a command line; empty for the domain of everything.
[[nodiscard]] std::string within_option(const properties::Domain& domain);

/// "1000 cases of each of 26 families" or "10 s on 26 families in turn". If the run is one of several shards, the shard
/// follows. If each subject stopped at its first violation, a note says so.
[[nodiscard]] std::string extent_of(const Run& run);

/// For a run with a budget: the number of cases that the subject was judged on, and the family with the fewest cases. A
/// verdict "sound" refers to these cases. Precondition: there is a family.
[[nodiscard]] std::string cases_judged(const Run& run, const properties::SubjectResult& result);

/// The changes that families made to cases after drawing them: one sentence for each kind of change, with its number
/// of cases.
[[nodiscard]] std::string adjusted_sentences(const Run& run);

/// "15.2 / 14.0 / 12.9", or no_number.
[[nodiscard]] std::string in_words(const Digits& digits);

/// "3 violated", or the status.
[[nodiscard]] std::string verdict_in_words(const properties::SubjectResult& result);

/// The worst backward error [ulps] with three significant digits, or no_number for a law that determines no outcome.
[[nodiscard]] std::string worst_in_words(const Run& run, const properties::SubjectResult& result);

/// "12 of 1000".
[[nodiscard]] std::string violated_of_judged(const properties::Count& count);

/// "12 of 1000 judged cases".
[[nodiscard]] std::string violated_of_judged_cases(const properties::Count& count);

/// The energy that the subject's answers gain, in one sentence. Empty if no answer to a colliding contact was judged.
[[nodiscard]] std::string energy_in_words(const Run& run, std::size_t subject);

/// The ways on of the subject, one line each: "sound within moment_ratio=:1300 (7200 fresh cases)".
[[nodiscard]] std::vector<std::string> ways_on(const Run& run, std::size_t subject);

/// The names, separated by commas.
[[nodiscard]] std::string listed(const std::vector<std::string>& names);
[[nodiscard]] std::string listed(const std::vector<const properties::Invariant*>& invariants);

/// The result of a run in a sentence.
[[nodiscard]] std::string summary_of(const Run& run);

/// The format of a duration, for error messages.
inline constexpr const char* duration_form = "a number and a unit, for example 500ms, 10s, 2m or 1h, from 1ms to 1000h";

/// Parses "500ms", "10s", "2m" or "1.5h": a decimal number followed by its unit. None if the text is anything else, or
/// if the duration is less than a millisecond or more than 1000 hours.
[[nodiscard]] std::optional<std::chrono::nanoseconds> duration_from(std::string_view text);

/// The duration in words, with the largest unit that leaves no fraction: "500 ms", "90 s" or "2 m". A fraction of a
/// millisecond is left out.
[[nodiscard]] std::string in_words(std::chrono::nanoseconds duration);

}  // namespace carom::report
