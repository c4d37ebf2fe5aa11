// SPDX-License-Identifier: BSL-1.0
#include "compare/trend_html.hpp"

#include <cstddef>
#include <functional>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compare/comparison_words.hpp"
#include "compare/trend_line.hpp"
#include "report/html_tables.hpp"
#include "report/markup.hpp"
#include "report/page.hpp"

namespace carom::tool::compare {
namespace {

using Value = std::function<std::optional<double>(const SubjectSummary&)>;

void add_lines(pugi::xml_node section, const Trends& trends, const SubjectTrend& trend) {
  const pugi::xml_node drawings = add(section, "div", {{"class", "drawings"}});
  const auto add_line = [&](const char* what, const Value& value) {
    std::vector<std::optional<double>> values(trends.reports.size());
    std::string said;
    for (const TrendPoint& point : trend.points) {
      values[point.report] = value(point.summary);
      const std::optional<double>& one = values[point.report];
      said += (said.empty() ? "" : ", ") + (one ? fmt::format("{:.3g}", *one) : "none");
    }
    const pugi::xml_node figure = add(drawings, "figure");
    add_trend_line(figure, fmt::format("{}, from report to report: {}", what, said), values);
    add(figure, "figcaption", {}, what);
  };
  add_line("worst backward error [ulps]", [](const SubjectSummary& summary) { return summary.worst_backward_error; });
  add_line("cases violated", [](const SubjectSummary& summary) -> std::optional<double> {
    return summary.status == "absent" ? std::nullopt
                                      : std::optional<double>(static_cast<double>(summary.violated_cases));
  });
}

std::string differences_text(const TrendPoint& point) {
  std::string text;
  for (const Difference& difference : point.differences) {
    text += (text.empty() ? "" : "; ") + difference_in_words(difference);
  }
  return text;
}

void add_point(pugi::xml_node body, const Trends& trends, const TrendPoint& point) {
  const ReadReport& report = trends.reports[point.report];
  const SubjectSummary& summary = point.summary;
  const pugi::xml_node row = add(body, "tr");
  const pugi::xml_node header = add(row, "th", {{"scope", "row"}});
  add_text(header, report.date);
  add(header, "small", {}, report.file);
  add(row, "td", {{"class", "word"}}, summary.version);
  add(row, "td", {{"class", "verdict " + summary.status}}, summary.status);
  add(row, "td", {}, fmt::format("{}", fmt::join(summary.violated, ", ")));
  add(row, "td", {{"class", "number"}}, std::to_string(summary.violated_cases));
  add(row, "td", {{"class", "number"}}, backward_error_text(summary.worst_backward_error));
  add(row, "td", {{"class", "number"}}, digits_text(summary));
  add(row, "td", {{"class", "number"}},
      summary.nanoseconds_per_solve ? fmt::format("{:.0f}", *summary.nanoseconds_per_solve) : "–");
  add(row, "td", {{"class", point.became_violated.empty() ? "" : "violated"}}, in_words(point.became_violated));
  add(row, "td", {}, in_words(point.fixed));
  add(row, "td", {}, differences_text(point));
}

}  // namespace

std::string trends_html(const Trends& trends, const std::vector<std::string>& unread) {
  pugi::xml_document document;
  document.append_child(pugi::node_doctype).set_value("html");
  pugi::xml_node html = document.append_child("html");
  html.append_attribute("lang") = "en";
  add_head(html, fmt::format("Carom: {} subjects in {} reports", trends.subjects.size(), trends.reports.size()));
  const pugi::xml_node body = add(html, "body");
  add(add(body, "header"), "h1", {}, "Carom: from report to report");
  const pugi::xml_node main = add(body, "main");
  add(main, "p", {},
      fmt::format(
          "{} subjects in {} reports, in the order of their dates. The lines are drawn to the logarithm of 1 + "
          "the number, from 0 at the bottom to the largest at the top. A row is compared with the last before it "
          "that judged the subject.",
          trends.subjects.size(), trends.reports.size()));
  for (const std::string& why : unread) {
    add(main, "p", {{"class", "result exit-2"}}, "Not read: " + why);
  }
  for (const SubjectTrend& trend : trends.subjects) {
    const pugi::xml_node section = add(main, "section");
    add(section, "h2", {}, trend.name);
    add_lines(section, trends, trend);
    const pugi::xml_node table = add_table(section, trend.name + ", report by report", "coverage");
    add_column_headers(
        table, {"report", "version", "status", "violated invariants", "cases violated", "worst backward error [ulps]",
                "digits p50 / p99 / worst", "ns/solve", "became violated", "fixed", "asked otherwise"});
    const pugi::xml_node rows = add(table, "tbody");
    for (const TrendPoint& point : trend.points) {
      add_point(rows, trends, point);
    }
  }
  add(add(body, "footer"), "p", {}, "How to read this page: docs/guide/reading-a-report.md.");
  return serialized(document) + '\n';
}

}  // namespace carom::tool::compare
