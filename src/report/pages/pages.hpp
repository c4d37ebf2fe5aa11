// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/properties/widest_domain/widest_domain.hpp>
#include <carom/report/results/run.hpp>

/// Every form of a run or a comparison. `out_directory` is the directory of the run's witnesses; empty if they are not
/// written.
namespace carom::report {

/// The run for a terminal: a line for each subject, and the faults. If `has_coverage`, it also has what was generated.
[[nodiscard]] std::string run_text(const Run& run, const std::string& out_directory, bool has_coverage = false);

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

struct MeasuredDomain {
  std::string subject;
  std::vector<std::string> deviates;  // deviations from the command line
  properties::WidestDomainOptions options;
  properties::WidestDomain widest;
  DeclaredEffects effects = {};  // of the subject

  /// Whether the subject could be judged in the core, and holds there.
  [[nodiscard]] bool is_known() const { return widest.ends.error.empty() && !widest.ends.in_core; }
};

/// The measured domain as docs/reference/schemas/domain.schema.json describes it.
[[nodiscard]] nlohmann::json widest_domain_record(const MeasuredDomain& measured);

/// The measured domain for a terminal.
[[nodiscard]] std::string widest_domain_text(const MeasuredDomain& measured);

/// One bar for each quantity, with the range of another domain beside it, as SVG. Precondition: the domain is known.
[[nodiscard]] std::string widest_domain_svg(const MeasuredDomain& measured, const properties::Domain& beside,
                                            const std::string& name_of_beside);

}  // namespace carom::report
