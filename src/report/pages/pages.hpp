// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <carom/report/model/run.hpp>

/// Everything that shows a run or a comparison. `out_directory` is where the witnesses of the run are written; empty if
/// they are not.
namespace carom::report {

/// For a terminal.
[[nodiscard]] std::string run_text(const Run& run, const std::string& out_directory);

/// For the page of a job, or a comment on a merge request: of the subjects that count, not longer than a megabyte.
[[nodiscard]] std::string run_markdown(const Run& run, const std::string& out_directory);

/// report.html: one page that needs nothing else, neither script nor network, and is well-formed XML as well.
[[nodiscard]] std::string run_html(const Run& run, const std::string& out_directory);

/// The subjects of a run as a table in Markdown.
[[nodiscard]] std::string subjects_markdown(const Run& run);

/// The run as JUnit's XML: a suite for each subject, a test for each invariant that it claims.
[[nodiscard]] std::string junit_xml(const Run& run);

/// The run as workflow commands of GitHub, a line each, for the subjects that count. Each invariant that a subject
/// violates gives an error, and so does each subject that could not be judged. A notice with the verdict on all ends
/// it.
[[nodiscard]] std::string github_annotations(const Run& run, const std::string& out_directory);

/// The verdict as shields.io's endpoint badge reads it (https://shields.io/badges/endpoint-badge).
[[nodiscard]] nlohmann::json badge_record(const Run& run);

/// A comparison for a terminal, for a comment on a merge request, and as a page. The text's last line is the sum.
[[nodiscard]] std::string comparison_text(const Comparison& comparison);
[[nodiscard]] std::string comparison_markdown(const Comparison& comparison);
[[nodiscard]] std::string comparison_html(const Comparison& comparison);

}  // namespace carom::report
