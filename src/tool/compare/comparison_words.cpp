// SPDX-License-Identifier: BSL-1.0
#include "compare/comparison_words.hpp"

#include <optional>

#include <fmt/format.h>

namespace carom::tool::compare {
namespace {

constexpr const char* none = "–";

std::string share_of(const ReadCount& count) { return fmt::format("{} of {}", count.violated, count.judged()); }

std::string of_cases(const ReadCount& count) { return share_of(count) + " cases"; }

std::string in_tenths(const std::optional<double>& digits) { return digits ? fmt::format("{:.1f}", *digits) : none; }

/// In few digits; "–" where there is none.
std::string backward_error_text(const std::optional<double>& ulps) {
  return ulps ? fmt::format("{:.3g}", *ulps) : none;
}

std::string digits_text(const SubjectSummary& summary) {
  return summary.digits_p50 ? fmt::format("{} / {} / {}", in_tenths(summary.digits_p50), in_tenths(summary.digits_p99),
                                          in_tenths(summary.digits_worst))
                            : none;
}

std::string worst_text(const SubjectSummary& summary) {
  const std::string error = backward_error_text(summary.worst_backward_error);
  return summary.worst_family.empty() ? error : fmt::format("{} ({})", error, summary.worst_family);
}

}  // namespace

const char* const differences_mean =
    "The runs differ in what they were asked: counts and worst values are not comparable, and what is new or fixed may "
    "be so for that alone.";

std::string counts_in_words(const ComparedViolation& violation) {
  switch (violation.change) {
    case Change::newly_violated:
      return fmt::format("{}, held in all {} before", of_cases(violation.now), violation.before.judged());
    case Change::violated_unknown:
      return of_cases(violation.now) + ", not judged before";
    case Change::known:
      return violation.before.violated == violation.now.violated && violation.before.judged() == violation.now.judged()
                 ? of_cases(violation.now)
                 : fmt::format("{} → {}", of_cases(violation.before), of_cases(violation.now));
    case Change::fixed:
      return fmt::format("{} before, holds in all {} now", of_cases(violation.before), violation.now.judged());
    case Change::no_longer_judged:
      break;
  }
  return of_cases(violation.before) + " before, not judged now";
}

std::string counts_in_short(const ComparedViolation& violation) {
  if (violation.now.violated == 0) {
    return share_of(violation.before) + " before";
  }
  const std::string now = share_of(violation.now);
  return violation.before.violated == 0 || share_of(violation.before) == now ? now
                                                                             : share_of(violation.before) + " → " + now;
}

std::string run_in_words(const ReadReport& report) {
  std::string text = fmt::format("Carom {}, {}, seed {}, ", report.carom, report.date, report.seed);
  text += report.cases ? fmt::format("{} cases of each of {} families", *report.cases, report.families.size())
                       : fmt::format("{} families in turn", report.families.size());
  return report.shard.empty() ? text : text + ", shard " + report.shard;
}

std::string status_in_words(const ComparedSubject& subject) {
  if (!subject.before) {
    return "came: " + subject.now->status;
  }
  if (!subject.now) {
    return "went: " + subject.before->status;
  }
  return subject.before->status == subject.now->status ? subject.now->status
                                                       : subject.before->status + " → " + subject.now->status;
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
      changes.push_back({what, old_text.empty() ? none : old_text, new_text.empty() ? none : new_text});
    }
  };
  note("version", before.version, now.version);
  note("law", before.model, now.model);
  note("precision", before.precision, now.precision);
  note("cases", std::to_string(before.cases), std::to_string(now.cases));
  note("cases violated", std::to_string(before.violated_cases), std::to_string(now.violated_cases));
  note("worst backward error [ulps]", worst_text(before), worst_text(now));
  note("digits p50 / p99 / worst", digits_text(before), digits_text(now));
  return changes;
}

std::string difference_in_words(const Difference& difference) {
  return fmt::format("{}: {} before, {} now", difference.what, difference.before, difference.now);
}

}  // namespace carom::tool::compare
