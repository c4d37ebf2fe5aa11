// SPDX-License-Identifier: BSL-1.0
#include "report/html_deviations.hpp"

#include <algorithm>
#include <string>

#include "report/html_tables.hpp"
#include "report/markup.hpp"
#include "report/not_claimed.hpp"

namespace carom::tool {

namespace {

bool claims_all(const Subject& subject) {
  return subject.deviates.empty() && not_claimed_without_matrix(subject).empty();
}

}  // namespace

void add_deviations(pugi::xml_node section, const GateRun& run) {
  const auto& results = run.report.results;
  if (std::all_of(results.begin(), results.end(), [](const auto& result) { return claims_all(result.subject); })) {
    return;
  }
  add(section, "h3", {}, "Not claimed");
  add(section, "p", {},
      "What a subject does not claim was not judged, and holds nowhere by that; behind @ the one family where it is "
      "not claimed.");
  const pugi::xml_node table = add_table(section, "What is not claimed", "coverage");
  add_column_headers(table, {"subject", "invariant", "why"});
  const pugi::xml_node body = add(table, "tbody");
  const auto add_row = [&](const Subject& subject, const std::string& invariant, const char* why) {
    const pugi::xml_node row = add(body, "tr");
    add(row, "th", {{"scope", "row"}}, subject.name);
    add(row, "td", {{"class", "word"}}, invariant);
    add(row, "td", {{"class", "word"}}, why);
  };
  for (const properties::SubjectResult& result : results) {
    for (const std::string& deviation : result.subject.deviates) {
      const bool is_own = std::find(run.deviates.begin(), run.deviates.end(), deviation) == run.deviates.end();
      add_row(result.subject, deviation, is_own ? "by its own word" : "by --deviates");
    }
    for (const std::string& invariant : not_claimed_without_matrix(result.subject)) {
      add_row(result.subject, invariant, shows_no_matrix);
    }
  }
}

}  // namespace carom::tool
