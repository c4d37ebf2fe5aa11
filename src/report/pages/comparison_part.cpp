// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

/// The violated and judged cases: "12 of 1000"; for a violation in both reports with different counts, "12 of 1000 → 15
/// of 1000"; for a violation in the older report alone, "12 of 1000 before".
std::string counts_in_short(const ComparedViolation& violation) {
  if (violation.now.violated == 0) {
    return violated_of_judged(violation.before) + " before";
  }
  const std::string now = violated_of_judged(violation.now);
  return violation.before.violated == 0 || violated_of_judged(violation.before) == now
             ? now
             : violated_of_judged(violation.before) + " → " + now;
}

Row row_of(const ComparedSubject& subject, std::string_view change, bool is_news, std::string what, std::string where) {
  return {{subject.name + (subject.counts || !subject.is_now ? "" : " (does not count)"),
           Cell(std::string(change), is_news ? "word violated" : "word"), Cell(std::move(what), "word"),
           Cell(std::move(where), "text")}};
}

/// Adds a row for each invariant that has this change, with the families: "generic (12 of 1000), …".
void add_violations(Table& table, const ComparedSubject& subject, Change change) {
  std::string last;
  for (const ComparedViolation& violation : subject.violations) {
    if (violation.change != change) {
      continue;
    }
    std::string where = fmt::format("{} ({})", violation.family, counts_in_short(violation));
    if (violation.invariant == last) {
      table.rows.back().cells.back().text += ", " + where;
      continue;
    }
    last = violation.invariant;
    table.rows.push_back(row_of(subject, in_words(change), is_new(change), violation.invariant, std::move(where)));
  }
}

Table changes_table(const Comparison& comparison, bool has_known) {
  Table table{"Changes", {{"subject"}, {"change"}, {"invariant"}, {"in (violated of judged cases)"}}, {}};
  for (const ComparedSubject& subject : comparison.subjects) {
    if (subject.cannot_be_judged_now) {
      table.rows.push_back(row_of(subject, "new: cannot be judged", true, no_number, subject.error));
    }
  }
  for (const Change change :
       {Change::newly_violated, Change::violated_unknown, Change::fixed, Change::no_longer_judged, Change::known}) {
    for (const ComparedSubject& subject : comparison.subjects) {
      if (change != Change::known || has_known) {
        add_violations(table, subject, change);
      }
    }
  }
  for (const ComparedSubject& subject : comparison.subjects) {
    if (!subject.is_now || !subject.was_before) {
      table.rows.push_back(
          row_of(subject, subject.is_now ? "only in the new report" : "only in the old report", false, "", ""));
    }
    if (!subject.no_longer_claimed.empty()) {
      table.rows.push_back(row_of(subject, "no longer claimed", false, listed(subject.no_longer_claimed), ""));
    }
  }
  return table;
}

}  // namespace

Document comparison_part(const Comparison& comparison, bool has_known) {
  Document document;
  if (!comparison.differences.empty()) {
    List list;
    for (const Difference& difference : comparison.differences) {
      list.items.push_back(fmt::format("{}: {} before, {} now", difference.what, difference.before, difference.now));
    }
    document.emplace_back(
        Paragraph{"Not comparable. The runs have different settings. Their counts are not comparable. The settings "
                  "alone may be the reason for new and fixed violations.",
                  "result exit-2"});
    document.emplace_back(std::move(list));
  }
  if (Table table = changes_table(comparison, has_known); !table.rows.empty()) {
    document.emplace_back(std::move(table));
  }
  return document;
}

std::string comparison_text(const Comparison& comparison) {
  Document document = comparison_part(comparison, true);
  document.emplace_back(Section{"", {Paragraph{summary_of(comparison)}}});
  return in_text(document);
}

}  // namespace carom::report
