// SPDX-License-Identifier: BSL-1.0
#include <optional>

#include <fmt/format.h>

#include <carom/report/results/comparison_words.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

std::string worst_text(const SubjectSummary& summary) {
  const std::string error =
      summary.worst_backward_error ? fmt::format("{:.3g}", *summary.worst_backward_error) : no_number;
  return summary.worst_family.empty() ? error : fmt::format("{} ({})", error, summary.worst_family);
}

}  // namespace

const char* const differences_mean =
    "The runs have different settings. Their counts and worst values are not comparable. The settings alone may be the "
    "reason for new and fixed violations.";

std::string counts_in_short(const ComparedViolation& violation) {
  if (violation.now.violated == 0) {
    return violated_of_judged(violation.before) + " before";
  }
  const std::string now = violated_of_judged(violation.now);
  return violation.before.violated == 0 || violated_of_judged(violation.before) == now
             ? now
             : violated_of_judged(violation.before) + " → " + now;
}

std::string run_in_words(const RunHeading& report) {
  std::string text = fmt::format("Carom {}, {}, seed {}, ", report.carom, report.date, report.seed);
  text += report.cases ? fmt::format("{} cases of each of {} families", *report.cases, report.families)
                       : fmt::format("{} families in turn", report.families);
  return report.shard.empty() ? text : text + ", shard " + report.shard;
}

std::string status_in_words(const ComparedSubject& subject) {
  if (!subject.before) {
    return fmt::format("came: {}", name_of(subject.now->status));
  }
  if (!subject.now) {
    return fmt::format("went: {}", name_of(subject.before->status));
  }
  const std::string now(name_of(subject.now->status));
  return subject.before->status == subject.now->status ? now
                                                       : fmt::format("{} → {}", name_of(subject.before->status), now);
}

std::vector<ChangedNumber> changed_numbers(const ComparedSubject& subject) {
  if (!subject.before || !subject.now) {
    return {};
  }
  std::vector<ChangedNumber> changes;
  const SubjectSummary& before = *subject.before;
  const SubjectSummary& now = *subject.now;
  const auto note = [&](const char* what, const std::string& old_text, const std::string& new_text) {
    if (old_text != new_text) {
      changes.push_back({what, old_text.empty() ? no_number : old_text, new_text.empty() ? no_number : new_text});
    }
  };
  note("version", before.version, now.version);
  note("law", before.law, now.law);
  note("precision", before.precision, now.precision);
  note("cases", std::to_string(before.cases), std::to_string(now.cases));
  note("cases violated", std::to_string(before.violated_cases), std::to_string(now.violated_cases));
  note("worst backward error [ulps]", worst_text(before), worst_text(now));
  note("digits p50 / p99 / worst", in_words(before.digits), in_words(now.digits));
  return changes;
}

std::string difference_in_words(const Difference& difference) {
  return fmt::format("{}: {} before, {} now", difference.what, difference.before, difference.now);
}

}  // namespace carom::report
