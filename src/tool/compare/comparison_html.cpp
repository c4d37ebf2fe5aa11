// SPDX-License-Identifier: BSL-1.0
#include "compare/comparison_html.hpp"

#include <initializer_list>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compare/comparison_words.hpp"
#include "report/html_tables.hpp"
#include "report/markup.hpp"
#include "report/page.hpp"

namespace carom::tool::compare {
namespace {

pugi::xml_node add_row(pugi::xml_node body, const std::string& name) {
  const pugi::xml_node row = add(body, "tr");
  add(row, "th", {{"scope", "row"}}, name);
  return row;
}

void add_word(pugi::xml_node row, const std::string& text, const char* look = "word") {
  add(row, "td", {{"class", look}}, text);
}

void add_differences(pugi::xml_node section, const Comparison& comparison) {
  if (comparison.differences.empty()) {
    return;
  }
  add(section, "p", {{"class", "result exit-2"}}, std::string("Not comparable. ") + differences_mean);
  const pugi::xml_node table = add_table(section, "In what the runs differ", "coverage");
  add_column_headers(table, {"what", "before", "now"});
  const pugi::xml_node body = add(table, "tbody");
  for (const Difference& difference : comparison.differences) {
    const pugi::xml_node row = add_row(body, difference.what);
    add_word(row, difference.before, "text");
    add_word(row, difference.now, "text");
  }
}

bool has_any(const Comparison& comparison, std::initializer_list<Change> changes) {
  for (const Change change : changes) {
    if (comparison.count(change) > 0) {
      return true;
    }
  }
  return false;
}

void add_violations(pugi::xml_node section, const Comparison& comparison, const char* caption,
                    std::initializer_list<Change> changes) {
  if (!has_any(comparison, changes)) {
    return;
  }
  const pugi::xml_node table = add_table(section, caption, "coverage");
  add_column_headers(table, {"subject", "invariant", "family", "", "cases"});
  const pugi::xml_node body = add(table, "tbody");
  for (const Change change : changes) {
    for (const ComparedSubject& subject : comparison.subjects) {
      for (const ComparedViolation& violation : subject.violations) {
        if (violation.change == change) {
          const pugi::xml_node row = add_row(body, subject.name + (subject.counts ? "" : " (does not count)"));
          add_word(row, violation.invariant);
          add_word(row, violation.family);
          add_word(row, std::string(in_words(change)), is_new(change) ? "word violated" : "word");
          add_word(row, counts_in_words(violation));
        }
      }
    }
  }
}

void add_unjudged(pugi::xml_node section, const Comparison& comparison) {
  for (const ComparedSubject& subject : comparison.subjects) {
    if (subject.cannot_be_judged_now) {
      add(section, "p", {{"class", "result exit-2"}},
          fmt::format("New: {} cannot be judged: {}", subject.name, subject.now->error));
    }
  }
}

std::string changes_of(const ComparedSubject& subject) {
  std::string text;
  for (const ChangedNumber& number : changed_numbers(subject)) {
    text += fmt::format("{}{}: {} → {}", text.empty() ? "" : "; ", number.what, number.before, number.now);
  }
  if (!subject.no_longer_claimed.empty()) {
    text +=
        fmt::format("{}no longer claimed: {}", text.empty() ? "" : "; ", fmt::join(subject.no_longer_claimed, ", "));
  }
  return text.empty() ? "nothing" : text;
}

void add_subjects_compared(pugi::xml_node section, const Comparison& comparison) {
  const pugi::xml_node table = add_table(section, "Subjects: what changed", "coverage");
  add_column_headers(table, {"subject", "status", "counts", "changed"});
  const pugi::xml_node body = add(table, "tbody");
  for (const ComparedSubject& subject : comparison.subjects) {
    const pugi::xml_node row = add_row(body, subject.name);
    add_word(row, status_in_words(subject));
    add_word(row, subject.counts ? "yes" : "no");
    add_word(row, changes_of(subject), "text");
  }
}

}  // namespace

void add_comparison(pugi::xml_node section, const Comparison& comparison) {
  add(section, "p", {{"class", comparison.count_new(false) > 0 ? "result exit-1" : "result exit-0"}},
      summary_of(comparison));
  add_facts(section, {{"before", comparison.before.file},
                      {"its run", run_in_words(comparison.before)},
                      {"now", comparison.now.file},
                      {"this run", run_in_words(comparison.now)}});
  add_differences(section, comparison);
  add_unjudged(section, comparison);
  add_violations(section, comparison, "New", {Change::newly_violated, Change::violated_unknown});
  add_violations(section, comparison, "Fixed, and no longer judged", {Change::fixed, Change::no_longer_judged});
  add_violations(section, comparison, "Known", {Change::known});
  add_subjects_compared(section, comparison);
}

std::string comparison_html(const Comparison& comparison) {
  pugi::xml_document document;
  document.append_child(pugi::node_doctype).set_value("html");
  pugi::xml_node html = document.append_child("html");
  html.append_attribute("lang") = "en";
  add_head(html, "Carom: " + summary_of(comparison));
  const pugi::xml_node body = add(html, "body");
  add(add(body, "header"), "h1", {}, "Carom: two reports compared");
  add_comparison(add(body, "main"), comparison);
  add(add(body, "footer"), "p", {}, "How to read this page: docs/guide/reading-a-report.md.");
  return serialized(document) + '\n';
}

}  // namespace carom::tool::compare
