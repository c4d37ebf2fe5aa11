// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_deviations.hpp"

#include <algorithm>
#include <string>

#include "report/html_tables.hpp"
#include "report/markup.hpp"

namespace carom::tool {

void add_deviations(pugi::xml_node section, const GateRun& run) {
  const auto& results = run.report.results;
  if (std::all_of(results.begin(), results.end(), [](const auto& result) { return result.subject.deviates.empty(); })) {
    return;
  }
  add(section, "h3", {}, "Not claimed");
  add(section, "p", {},
      "What a subject does not claim was not judged, and holds nowhere by that; behind @ the one family where it is "
      "not "
      "claimed.");
  const pugi::xml_node table = add_table(section, "What is not claimed", "coverage");
  add_column_headers(table, {"subject", "invariant", "by"});
  const pugi::xml_node body = add(table, "tbody");
  for (const properties::SubjectResult& result : results) {
    for (const std::string& deviation : result.subject.deviates) {
      const bool is_own = std::find(run.deviates.begin(), run.deviates.end(), deviation) == run.deviates.end();
      const pugi::xml_node row = add(body, "tr");
      add(row, "th", {{"scope", "row"}}, result.subject.name);
      add(row, "td", {{"class", "word"}}, deviation);
      add(row, "td", {{"class", "word"}}, is_own ? "its own word" : "--deviates");
    }
  }
}

}  // namespace carom::tool
