// SPDX-License-Identifier: BSL-1.0
#include "compare/comparison_markdown.hpp"

#include <string_view>

#include <fmt/format.h>

#include "compare/comparison_words.hpp"

namespace carom::tool::compare {
namespace {

/// The text as a cell of a Markdown table can hold it: nothing in it ends the cell, or is read as markup.
std::string markdown_cell(const std::string& text) {
  constexpr std::string_view markup = "\\`*_{}[]()#+!|~";
  std::string cell;
  for (const char letter : text) {
    if (letter == '<') {
      cell += "&lt;";
    } else if (letter == '&') {
      cell += "&amp;";
    } else {
      cell += markup.find(letter) == std::string_view::npos ? "" : "\\";
      cell += letter;
    }
  }
  return cell;
}

std::string violation_rows(const Comparison& comparison) {
  std::string rows;
  for (const Change change :
       {Change::newly_violated, Change::violated_unknown, Change::fixed, Change::no_longer_judged, Change::known}) {
    for (const ComparedSubject& subject : comparison.subjects) {
      for (const ComparedViolation& violation : subject.violations) {
        if (violation.change == change) {
          rows += fmt::format("| {} | {} | {} | {} | {} |\n", in_words(change), markdown_cell(subject.name),
                              markdown_cell(violation.invariant), markdown_cell(violation.family),
                              counts_in_words(violation));
        }
      }
    }
  }
  return rows;
}

std::string subject_row(const ComparedSubject& subject) {
  std::string changes;
  if (subject.cannot_be_judged_now) {
    changes = "new: cannot be judged: " + markdown_cell(subject.now->error);
  }
  for (const std::string& claim : subject.no_longer_claimed) {
    changes += (changes.empty() ? "" : "; ") + ("no longer claimed: " + markdown_cell(claim));
  }
  for (const ChangedNumber& number : changed_numbers(subject)) {
    changes += fmt::format("{}{}: {} → {}", changes.empty() ? "" : "; ", number.what, markdown_cell(number.before),
                           markdown_cell(number.now));
  }
  return fmt::format("| {} | {} | {} | {} |\n", markdown_cell(subject.name), status_in_words(subject),
                     subject.counts ? "yes" : "no", changes.empty() ? "–" : changes);
}

}  // namespace

std::string comparison_markdown(const Comparison& comparison) {
  std::string text = fmt::format("**{}**\n\n- before: {}: {}\n- now: {}: {}\n", summary_of(comparison),
                                 markdown_cell(comparison.before.file), markdown_cell(run_in_words(comparison.before)),
                                 markdown_cell(comparison.now.file), markdown_cell(run_in_words(comparison.now)));
  if (!comparison.differences.empty()) {
    text += fmt::format("\n**Not comparable.** {}\n\n", differences_mean);
    for (const Difference& difference : comparison.differences) {
      text += "- " + markdown_cell(difference_in_words(difference)) + '\n';
    }
  }
  if (const std::string rows = violation_rows(comparison); !rows.empty()) {
    text += "\n| | subject | invariant | family | cases |\n| --- | --- | --- | --- | --- |\n" + rows;
  }
  text += "\n| subject | status | counts | changed |\n| --- | --- | --- | --- |\n";
  for (const ComparedSubject& subject : comparison.subjects) {
    text += subject_row(subject);
  }
  return text;
}

}  // namespace carom::tool::compare
