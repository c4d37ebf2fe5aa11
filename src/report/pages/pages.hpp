// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <carom/report/results/run.hpp>

/// Every form of a run or a comparison. `out_directory` is the directory of the run's witnesses; empty if they are not
/// written.
namespace carom::report {

/// The run for a terminal.
[[nodiscard]] std::string run_text(const Run& run, const std::string& out_directory);

/// The run for the page of a job, or a comment on a merge request. It has only the subjects that count (those that
/// decide the exit status), and is not longer than about a megabyte.
[[nodiscard]] std::string run_markdown(const Run& run, const std::string& out_directory);

/// report.html: one page that needs no script, network or other file, and is well-formed XML too.
[[nodiscard]] std::string run_html(const Run& run, const std::string& out_directory);

/// The run as JUnit's XML: a suite for each subject, and a test for each invariant that it claims.
[[nodiscard]] std::string junit_xml(const Run& run);

/// The run as workflow commands of GitHub, one a line, for the subjects that count. A violated invariant is an error,
/// or a notice if the baseline knows it. A subject that could not be judged is an error. A diagnosis is a notice. The
/// last line is a notice with the overall verdict.
[[nodiscard]] std::string github_annotations(const Run& run, const std::string& out_directory);

/// A comparison for a terminal: one table. The last line is the summary.
[[nodiscard]] std::string comparison_text(const Comparison& comparison);

}  // namespace carom::report
