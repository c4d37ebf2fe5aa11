// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/properties/phenomena/phenomenon.hpp>
#include <carom/report/pictures/plot.hpp>
#include <carom/report/results/time_run.hpp>

/// Every form of the results of `carom time`.
namespace carom::report {

/// For a terminal: a table of engines by phenomena at one step, the reading that is farthest off in each, the relations
/// of the heap, and the claims.
[[nodiscard]] std::string time_text(const TimeRun& run);

/// report.html, with the pictures NAME-step.svg and NAME-time.svg beside it.
[[nodiscard]] std::string time_html(const TimeRun& run);

/// JUnit's XML: a suite for each engine, and a test for each phenomenon and each claim.
[[nodiscard]] std::string time_junit(const TimeRun& run);

/// The page of a phenomenon in docs/reference/phenomena, as Markdown.
[[nodiscard]] std::string phenomenon_page(const properties::Phenomenon& phenomenon, const TimeRun& run);

/// The error of the worst reading against the step, and against the time that a second of the scene takes. A line for
/// each engine, with its name at its end. Empty if no engine has two steps.
[[nodiscard]] std::vector<Plot> time_pictures(const properties::Phenomenon& phenomenon, const TimeRun& run);

}  // namespace carom::report
