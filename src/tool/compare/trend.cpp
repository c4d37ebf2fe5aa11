// SPDX-License-Identifier: BSL-1.0
#include "compare/trend.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace carom::tool::compare {
namespace {

SubjectTrend& trend_named(Trends& trends, const std::string& name) {
  const auto found = std::find_if(trends.subjects.begin(), trends.subjects.end(),
                                  [&](const SubjectTrend& trend) { return trend.name == name; });
  return found != trends.subjects.end() ? *found : trends.subjects.emplace_back(SubjectTrend{name, {}});
}

const ReadSubject& subject_in(const ReadReport& report, const std::string& name) {
  return *std::find_if(report.subjects.begin(), report.subjects.end(),
                       [&](const ReadSubject& subject) { return subject.name == name; });
}

/// The report of the last point that has something to compare with.
std::optional<std::size_t> last_judged(const SubjectTrend& trend) {
  const auto found = std::find_if(trend.points.rbegin(), trend.points.rend(),
                                  [](const TrendPoint& point) { return point.summary.cases > 0; });
  return found == trend.points.rend() ? std::nullopt : std::optional<std::size_t>(found->report);
}

void add_point(Trends& trends, std::size_t report, const ReadSubject& subject) {
  SubjectTrend& trend = trend_named(trends, subject.name);
  TrendPoint point{report, subject.summary, true, {}, {}, {}};
  if (const std::optional<std::size_t> before = last_judged(trend)) {
    point.is_first = false;
    point.differences = differences_between(trends.reports[*before], trends.reports[report]);
    const ComparedSubject compared = compare_subjects(&subject_in(trends.reports[*before], subject.name), &subject);
    for (const ComparedViolation& violation : compared.violations) {
      if (is_new(violation.change)) {
        point.became_violated.push_back(violation);
      } else if (violation.change == Change::fixed) {
        point.fixed.push_back(violation);
      }
    }
  }
  trend.points.push_back(std::move(point));
}

}  // namespace

Trends trends_of(std::vector<ReadReport> reports) {
  Trends trends{std::move(reports), {}};
  // Dates as ISO 8601 writes them, of one zone: in the order of their letters.
  std::stable_sort(trends.reports.begin(), trends.reports.end(),
                   [](const ReadReport& x, const ReadReport& y) { return x.date < y.date; });
  for (std::size_t report = 0; report < trends.reports.size(); ++report) {
    for (const ReadSubject& subject : trends.reports[report].subjects) {
      add_point(trends, report, subject);
    }
  }
  return trends;
}

std::string in_words(const std::vector<ComparedViolation>& violations) {
  std::string text;
  std::string last;
  for (const ComparedViolation& violation : violations) {
    text += violation.invariant == last ? ", " : (text.empty() ? "" : "; ") + violation.invariant + " in ";
    text += violation.family;
    last = violation.invariant;
  }
  return text;
}

}  // namespace carom::tool::compare
