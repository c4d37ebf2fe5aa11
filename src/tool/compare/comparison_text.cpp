// SPDX-License-Identifier: BSL-1.0
#include "compare/comparison_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compare/comparison_words.hpp"

namespace carom::tool::compare {
namespace {

std::string differences_text(const Comparison& comparison) {
  if (comparison.differences.empty()) {
    return {};
  }
  std::string text = std::string("NOT COMPARABLE. ") + differences_mean + '\n';
  for (const Difference& difference : comparison.differences) {
    text += "  " + difference_in_words(difference) + '\n';
  }
  return text;
}

/// What became of an invariant in the same way, a line an invariant: "new: restitution in generic (12 of 1000), …".
std::string change_lines(const ComparedSubject& subject, Change change) {
  std::string text;
  std::string last;
  for (const ComparedViolation& violation : subject.violations) {
    if (violation.change != change) {
      continue;
    }
    text += violation.invariant == last
                ? ", "
                : fmt::format("{}    {}: {} in ", text.empty() ? "" : "\n", in_words(change), violation.invariant);
    text += fmt::format("{} ({})", violation.family, counts_in_short(violation));
    last = violation.invariant;
  }
  return text.empty() ? text : text + '\n';
}

enum class Known { shown, left_out };

std::string changes_text(const ComparedSubject& subject, Known known) {
  std::string text;
  if (subject.cannot_be_judged_now) {
    text += fmt::format("    new: cannot be judged: {}\n", subject.now->error);
  }
  for (const Change change :
       {Change::newly_violated, Change::violated_unknown, Change::fixed, Change::no_longer_judged}) {
    text += change_lines(subject, change);
  }
  if (known == Known::shown) {
    text += change_lines(subject, Change::known);
  }
  if (!subject.no_longer_claimed.empty()) {
    text += fmt::format("    no longer claimed: {}\n", fmt::join(subject.no_longer_claimed, ", "));
  }
  return text;
}

std::string subject_text(const ComparedSubject& subject) {
  std::string text = fmt::format("{}: {}{}\n", subject.name, status_in_words(subject),
                                 subject.now && !subject.counts ? " (does not count)" : "");
  text += changes_text(subject, Known::shown);
  for (const ChangedNumber& number : changed_numbers(subject)) {
    text += fmt::format("    {}: {} → {}\n", number.what, number.before, number.now);
  }
  return text;
}

}  // namespace

std::string comparison_text(const Comparison& comparison) {
  std::string text = fmt::format("before  {}: {}\nnow     {}: {}\n", comparison.before.file,
                                 run_in_words(comparison.before), comparison.now.file, run_in_words(comparison.now));
  text += differences_text(comparison) + '\n';
  for (const ComparedSubject& subject : comparison.subjects) {
    text += subject_text(subject);
  }
  return text + '\n' + summary_of(comparison) + '\n';
}

std::string baseline_text(const Comparison& comparison) {
  std::string text = '\n' + differences_text(comparison);
  for (const ComparedSubject& subject : comparison.subjects) {
    const std::string changes = changes_text(subject, Known::left_out);
    if (!subject.now) {
      text += fmt::format("  {} was not judged in this run\n", subject.name);
    } else if (!changes.empty()) {
      text += fmt::format("  {}{}\n{}", subject.name, subject.counts ? "" : " (does not count)", changes);
    }
  }
  return text + fmt::format("Against the baseline {}: {}.\n", comparison.before.file, baseline_verdict(comparison));
}

}  // namespace carom::tool::compare
