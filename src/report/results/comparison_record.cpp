// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <initializer_list>
#include <optional>

#include <carom/collision/json/json.hpp>
#include <carom/report/results/comparison_record.hpp>
#include <carom/report/results/comparison_words.hpp>
#include <carom/report/results/version.hpp>

namespace carom::report {
namespace {

using nlohmann::json;

json run_record(const RunHeading& report) {
  return {{"file", report.file},
          {"carom", report.carom},
          {"date", report.date},
          {"seed", report.seed},
          {"cases_of_each_family", report.cases ? json(*report.cases) : json()}};
}

json differences_record(const Comparison& comparison) {
  json list = json::array();
  for (const Difference& difference : comparison.differences) {
    list.push_back({{"what", difference.what}, {"before", difference.before}, {"now", difference.now}});
  }
  return list;
}

json count_record(const properties::Count& count) { return {{"holds", count.holds}, {"violated", count.violated}}; }

/// The violations with these changes. `counts` tells whether the subject decides the exit status. A subject that can no
/// longer be judged has no invariant, so it is not listed here.
json violations_record(const Comparison& comparison, std::initializer_list<Change> changes) {
  json list = json::array();
  for (const ComparedSubject& subject : comparison.subjects) {
    for (const ComparedViolation& violation : subject.violations) {
      if (std::find(changes.begin(), changes.end(), violation.change) != changes.end()) {
        list.push_back({{"subject", subject.name},
                        {"invariant", violation.invariant},
                        {"family", violation.family},
                        {"counts", subject.counts},
                        {"judged_before", violation.before.judged() > 0},
                        {"before", count_record(violation.before)},
                        {"now", count_record(violation.now)}});
      }
    }
  }
  return list;
}

json subject_names(const Comparison& comparison, bool (*is_listed)(const ComparedSubject&)) {
  json list = json::array();
  for (const ComparedSubject& subject : comparison.subjects) {
    if (is_listed(subject)) {
      list.push_back(subject.name);
    }
  }
  return list;
}

json changes_record(const Comparison& comparison) {
  return {{"comparable", comparison.differences.empty()},
          {"differences", differences_record(comparison)},
          {"new", violations_record(comparison, {Change::newly_violated, Change::violated_unknown})},
          {"known", violations_record(comparison, {Change::known})},
          {"fixed", violations_record(comparison, {Change::fixed})},
          {"no_longer_judged", violations_record(comparison, {Change::no_longer_judged})},
          {"cannot_be_judged_now",
           subject_names(comparison, [](const ComparedSubject& subject) { return subject.cannot_be_judged_now; })},
          {"came", subject_names(comparison, [](const ComparedSubject& subject) { return !subject.before; })},
          {"went", subject_names(comparison, [](const ComparedSubject& subject) { return !subject.now; })}};
}

json optional_number(const std::optional<double>& number) { return number ? number_to_json(*number) : json(); }

json summary_record(const std::optional<SubjectSummary>& summary) {
  if (!summary) {
    return nullptr;
  }
  return {{"status", name_of(summary->status)},
          {"error", summary->error},
          {"version", summary->version},
          {"cases", summary->cases},
          {"violated_cases", summary->violated_cases},
          {"violated", summary->violated},
          {"worst_backward_error",
           {{"ulps", optional_number(summary->worst_backward_error)}, {"family", summary->worst_family}}},
          {"digits",
           {{"p50", optional_number(summary->digits.p50)},
            {"p99", optional_number(summary->digits.p99)},
            {"worst", optional_number(summary->digits.worst)}}},
          {"deviates", summary->deviates}};
}

}  // namespace

json comparison_record(const Comparison& comparison) {
  json record = changes_record(comparison);
  record["carom"] = version;
  record["before"] = run_record(comparison.before);
  record["now"] = run_record(comparison.now);
  record["subjects"] = json::array();
  for (const ComparedSubject& subject : comparison.subjects) {
    record["subjects"].push_back({{"name", subject.name},
                                  {"counts", subject.counts},
                                  {"before", summary_record(subject.before)},
                                  {"now", summary_record(subject.now)},
                                  {"no_longer_claimed", subject.no_longer_claimed}});
  }
  return record;
}

json baseline_record(const Comparison& comparison) {
  json record = changes_record(comparison);
  record["report"] = run_record(comparison.before);
  return record;
}

}  // namespace carom::report
