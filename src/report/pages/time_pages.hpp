// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/phenomena/phenomenon.hpp>
#include <carom/report/results/time_run.hpp>

/// Every form of the results of `carom time`.
namespace carom::report {

/// For a terminal: a table of engines by phenomena at one step, the reading that is farthest off in each, the relations
/// of the heap, and the claims.
[[nodiscard]] std::string time_text(const TimeRun& run);

/// The first part of `time_text`: the table alone.
[[nodiscard]] std::string time_summary(const TimeRun& run);

/// report.html, with the pictures of `time_pictures` and `first_bounce_picture` beside it.
[[nodiscard]] std::string time_html(const TimeRun& run);

/// JUnit's XML: a suite for each engine, and a test for each phenomenon and each claim.
[[nodiscard]] std::string time_junit(const TimeRun& run);

/// The page of a phenomenon in docs/reference/phenomena, as Markdown.
[[nodiscard]] std::string phenomenon_page(const properties::Phenomenon& phenomenon, const TimeRun& run);

}  // namespace carom::report
