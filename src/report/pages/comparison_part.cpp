// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <span>

#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/results/comparison_words.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

constexpr Change news[] = {Change::newly_violated, Change::violated_unknown, Change::fixed, Change::no_longer_judged};
constexpr Change old_ones[] = {Change::known};

std::string name_of(const ComparedSubject& subject) {
  return subject.name + (subject.counts || !subject.now ? "" : " (does not count)");
}

/// Adds a row for each invariant that has this change, with the families: "generic (12 of 1000), …".
void add_rows(Table& table, const ComparedSubject& subject, Change change) {
  std::string last;
  for (const ComparedViolation& violation : subject.violations) {
    if (violation.change != change) {
      continue;
    }
    const std::string where = fmt::format("{} ({})", violation.family, counts_in_short(violation));
    if (violation.invariant == last) {
      table.rows.back().cells.back().text += ", " + where;
      continue;
    }
    last = violation.invariant;
    table.rows.push_back(
        {{name_cell(name_of(subject)), Cell(std::string(in_words(change)), is_new(change) ? "word violated" : "word"),
          Cell(violation.invariant, "word"), Cell(where, "text")}});
  }
}

void add_violations(Document& document, const Comparison& comparison, const char* caption,
                    std::span<const Change> changes) {
  Table table{caption, {{"subject"}, {""}, {"invariant"}, {"in (violated of judged cases)"}}, {}};
  for (const Change change : changes) {
    for (const ComparedSubject& subject : comparison.subjects) {
      add_rows(table, subject, change);
    }
  }
  if (!table.rows.empty()) {
    document.emplace_back(std::move(table));
  }
}

void add_differences(Document& document, const Comparison& comparison) {
  if (comparison.differences.empty()) {
    return;
  }
  document.emplace_back(Paragraph{std::string("Not comparable. ") + differences_mean, "result exit-2", true});
  List list;
  for (const Difference& difference : comparison.differences) {
    list.items.push_back(difference_in_words(difference));
  }
  document.emplace_back(std::move(list));
}

void add_lost(Document& document, const Comparison& comparison) {
  for (const ComparedSubject& subject : comparison.subjects) {
    if (subject.cannot_be_judged_now) {
      document.emplace_back(Paragraph{fmt::format("new: {} cannot be judged: {}", name_of(subject), subject.now->error),
                                      "result exit-2"});
    }
  }
}

std::string changes_of(const ComparedSubject& subject) {
  std::vector<std::string> changes;
  for (const ChangedNumber& number : changed_numbers(subject)) {
    changes.push_back(fmt::format("{}: {} → {}", number.what, number.before, number.now));
  }
  if (!subject.no_longer_claimed.empty()) {
    changes.push_back("no longer claimed: " + listed(subject.no_longer_claimed));
  }
  std::string text;
  for (const std::string& change : changes) {
    text += (text.empty() ? "" : "; ") + change;
  }
  return text.empty() ? "nothing" : text;
}

Table subjects_compared(const Comparison& comparison) {
  Table table{"Changes of the subjects", {{"subject"}, {"status"}, {"counts"}, {"changed"}}, {}};
  for (const ComparedSubject& subject : comparison.subjects) {
    table.rows.push_back({{name_cell(subject.name), Cell(status_in_words(subject), "word"),
                           Cell(subject.counts ? "yes" : "no", "word"), Cell(changes_of(subject), "text")}});
  }
  return table;
}

Paragraph sum_of(const Comparison& comparison) {
  return {summary_of(comparison), comparison.count_new(false) > 0 ? "result exit-1" : "result exit-0", true};
}

Document with_sum_first(const Comparison& comparison) {
  Document document = comparison_part(comparison);
  document.insert(document.begin(), Block(sum_of(comparison)));
  return document;
}

}  // namespace

Document comparison_part(const Comparison& comparison) {
  Document document;
  document.emplace_back(Facts{{{"before", comparison.before.file + ": " + run_in_words(comparison.before)},
                               {"now", comparison.now.file + ": " + run_in_words(comparison.now)}}});
  add_differences(document, comparison);
  add_lost(document, comparison);
  add_violations(document, comparison, "New, fixed, and no longer judged", news);
  add_violations(document, comparison, "Known", old_ones);
  document.emplace_back(subjects_compared(comparison));
  return document;
}

Document baseline_part(const Comparison& comparison) {
  Document document;
  add_differences(document, comparison);
  add_lost(document, comparison);
  add_violations(document, comparison, "New, fixed, and no longer judged", news);
  for (const ComparedSubject& subject : comparison.subjects) {
    if (!subject.now) {
      document.emplace_back(Paragraph{subject.name + " was not judged in this run"});
    } else if (!subject.no_longer_claimed.empty()) {
      document.emplace_back(
          Paragraph{fmt::format("{} no longer claims {}", name_of(subject), listed(subject.no_longer_claimed))});
    }
  }
  document.emplace_back(
      Paragraph{fmt::format("Against the baseline {}: {}.", comparison.before.file, baseline_verdict(comparison))});
  return document;
}

std::string comparison_text(const Comparison& comparison) {
  Document document = comparison_part(comparison);
  document.emplace_back(Section{"", {sum_of(comparison)}});
  return in_text(document);
}

std::string comparison_markdown(const Comparison& comparison) { return in_markdown(with_sum_first(comparison)); }

std::string comparison_html(const Comparison& comparison) {
  return html_page({"Carom: " + summary_of(comparison),
                    "Carom: comparison of two reports",
                    {},
                    with_sum_first(comparison),
                    "docs/guide/reading-a-report.md explains this page."});
}

}  // namespace carom::report
