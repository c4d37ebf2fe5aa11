// SPDX-License-Identifier: BSL-1.0
#include "compare/trend_markdown.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compare/comparison_markdown.hpp"
#include "compare/comparison_words.hpp"

namespace carom::tool::compare {
namespace {

std::string or_dash(const std::string& text) { return text.empty() ? "–" : markdown_cell(text); }

std::string row(const Trends& trends, const TrendPoint& point) {
  const ReadReport& report = trends.reports[point.report];
  const SubjectSummary& summary = point.summary;
  std::string asked;
  for (const Difference& difference : point.differences) {
    asked += (asked.empty() ? "" : "; ") + difference_in_words(difference);
  }
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", markdown_cell(report.date),
                     markdown_cell(report.file), or_dash(summary.version), markdown_cell(summary.status),
                     or_dash(fmt::format("{}", fmt::join(summary.violated, ", "))), summary.violated_cases,
                     backward_error_text(summary.worst_backward_error), digits_text(summary),
                     summary.nanoseconds_per_solve ? fmt::format("{:.0f}", *summary.nanoseconds_per_solve) : "–",
                     or_dash(in_words(point.became_violated)), or_dash(in_words(point.fixed)), or_dash(asked));
}

}  // namespace

std::string trends_markdown(const Trends& trends, const std::vector<std::string>& unread) {
  std::string text = fmt::format("# {} subjects in {} reports\n", trends.subjects.size(), trends.reports.size());
  for (const std::string& why : unread) {
    text += fmt::format("\nNot read: {}\n", markdown_cell(why));
  }
  for (const SubjectTrend& trend : trends.subjects) {
    text += fmt::format(
        "\n## {}\n\n| date | report | version | status | violated invariants | cases violated | worst backward error "
        "[ulps] | digits p50 / p99 / worst | ns/solve | became violated | fixed | asked otherwise |\n| --- | --- | --- "
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        markdown_cell(trend.name));
    for (const TrendPoint& point : trend.points) {
      text += row(trends, point);
    }
  }
  return text;
}

}  // namespace carom::tool::compare
