// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "compare/comparison.hpp"

/// What became of subjects from report to report.
namespace carom::tool::compare {

/// A subject in one report, beside the last before it that judged it.
struct TrendPoint {
  std::size_t report = 0;  // of the trends
  SubjectSummary summary;
  bool is_first = true;
  std::vector<ComparedViolation> became_violated;  // none of the first
  std::vector<ComparedViolation> fixed;
  std::vector<Difference> differences;  // in what the runs were asked otherwise
};

struct SubjectTrend {
  std::string name;
  std::vector<TrendPoint> points;  // in the order of the reports
};

struct Trends {
  std::vector<ReadReport> reports;     // in the order of their dates
  std::vector<SubjectTrend> subjects;  // in the order in which they came
};

[[nodiscard]] Trends trends_of(std::vector<ReadReport> reports);

/// "restitution in generic, head_on; energy in elastic".
[[nodiscard]] std::string in_words(const std::vector<ComparedViolation>& violations);

}  // namespace carom::tool::compare
