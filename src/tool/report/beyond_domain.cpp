// SPDX-License-Identifier: BSL-1.0
#include "report/beyond_domain.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>

#include "report/html_tables.hpp"
#include "report/markup.hpp"

namespace carom::tool {
namespace {

using nlohmann::json;
using properties::FamilyResult;
using properties::SubjectResult;

constexpr const char* nothing_judged = "–";

/// What was posed, and is judged.
std::uint64_t judged(const FamilyResult& family) {
  return family.cases - family.skipped -
         std::accumulate(family.unjudged.begin(), family.unjudged.end(), std::uint64_t{0});
}

/// "from 3.2e+07 on: 412 of 1000".
std::string boundary_in_words(const FamilyResult& family) {
  if (judged(family) == 0) {
    return nothing_judged;
  }
  return family.boundary
             ? fmt::format("from {:.2g} on: {} of {}", family.boundary->quantity, family.violated, judged(family))
             : fmt::format("nowhere, of {}", judged(family));
}

/// Of each family beyond the claimed domain.
std::vector<std::string> cells_of(const SubjectResult& result, std::size_t families) {
  std::vector<std::string> cells;
  for (const FamilyResult& family : result.beyond_domain) {
    cells.push_back(boundary_in_words(family));
  }
  cells.resize(families, nothing_judged);
  return cells;
}

bool was_posed(const GateRun& run) {
  const auto& results = run.report.results;
  return std::any_of(results.begin(), results.end(), [](const auto& result) { return !result.beyond_domain.empty(); });
}

std::vector<std::string> headings(const properties::GateOptions& options) {
  std::vector<std::string> names;
  for (const properties::Family* family : options.beyond_domain) {
    names.push_back(fmt::format("{} ({})", family->name, family->beyond.name));
  }
  return names;
}

constexpr const char* explanation =
    "The least of a quantity at which something is violated, and in how many of the cases that were judged. No verdict "
    "and no exit status depends on it.";

}  // namespace

json beyond_domain_families_record(const properties::GateOptions& options) {
  json record = json::array();
  for (const properties::Family* family : options.beyond_domain) {
    record.push_back({{"name", family->name}, {"summary", family->summary}, {"quantity", family->beyond.name}});
  }
  return record;
}

json beyond_domain_record(const SubjectResult& result, const properties::GateOptions& options) {
  json record = json::array();
  for (std::size_t f = 0; f < result.beyond_domain.size(); ++f) {
    const FamilyResult& family = result.beyond_domain[f];
    json boundary;
    if (family.boundary) {
      boundary = {{"quantity", number_to_json(family.boundary->quantity)},
                  {"case", family.boundary->index},
                  {"invariant", family.boundary->invariant}};
    }
    record.push_back({{"family", options.beyond_domain[f]->name},
                      {"cases", family.cases},
                      {"skipped", family.skipped},
                      {"not_judged", unjudged_record(family.unjudged)},
                      {"violated", family.violated},
                      {"boundary", std::move(boundary)}});
  }
  return record;
}

std::string beyond_domain_text(const GateRun& run) {
  if (!was_posed(run)) {
    return "";
  }
  const auto line = [](const std::string& name, const std::vector<std::string>& cells) {
    std::string text = fmt::format("{:40}", name);
    for (const std::string& cell : cells) {
      text += fmt::format(" {:>36}", cell);
    }
    return text + '\n';
  };
  const properties::GateOptions& options = run.report.options;
  std::vector<std::string> names;
  std::vector<std::string> quantities;
  for (const properties::Family* family : options.beyond_domain) {
    names.emplace_back(family->name);
    quantities.emplace_back(family->beyond.name);
  }
  std::string text = "\nbeyond the claimed domain: from where on something is violated; no verdict depends on it\n" +
                     line("subject", names) + line("", quantities);
  for (std::size_t s = 0; s < run.report.results.size(); ++s) {
    if (run.counts[s]) {
      const SubjectResult& result = run.report.results[s];
      text += line(result.subject.name, cells_of(result, options.beyond_domain.size()));
    }
  }
  return text;
}

std::string beyond_domain_markdown(const GateRun& run, const std::function<std::string(const std::string&)>& shown) {
  if (!was_posed(run)) {
    return "";
  }
  const properties::GateOptions& options = run.report.options;
  std::string text = fmt::format("\n### Beyond the claimed domain\n\n{}\n\n| subject |", explanation);
  std::string rule = "\n| --- |";
  for (const std::string& heading : headings(options)) {
    text += fmt::format(" {} |", heading);
    rule += " --- |";
  }
  text += rule + '\n';
  for (std::size_t s = 0; s < run.report.results.size(); ++s) {
    if (run.counts[s]) {
      const SubjectResult& result = run.report.results[s];
      text += fmt::format("| {} |", shown(result.subject.name));
      for (const std::string& cell : cells_of(result, options.beyond_domain.size())) {
        text += fmt::format(" {} |", cell);
      }
      text += '\n';
    }
  }
  return text;
}

void add_beyond_domain(pugi::xml_node section, const GateRun& run) {
  if (!was_posed(run)) {
    return;
  }
  const properties::GateOptions& options = run.report.options;
  add(section, "h3", {}, "Beyond the claimed domain");
  add(section, "p", {}, explanation);
  const pugi::xml_node table = add_table(section, "Where each subject stops beyond the claimed domain", "coverage");
  std::vector<std::string> names = headings(options);
  names.insert(names.begin(), "subject");
  add_column_headers(table, names);
  const pugi::xml_node body = add(table, "tbody");
  for (const SubjectResult& result : run.report.results) {
    const pugi::xml_node row = add(body, "tr");
    add(row, "th", {{"scope", "row"}}, result.subject.name);
    for (const std::string& cell : cells_of(result, options.beyond_domain.size())) {
      add(row, "td", {{"class", "word"}}, cell);
    }
  }
}

void add_beyond_domain_properties(pugi::xml_node suite, const SubjectResult& result,
                                  const properties::GateOptions& options) {
  if (result.beyond_domain.empty()) {
    return;
  }
  const pugi::xml_node list = add(suite, "properties");
  for (std::size_t f = 0; f < result.beyond_domain.size(); ++f) {
    add(list, "property",
        {{"name", fmt::format("beyond the claimed domain, {}", options.beyond_domain[f]->name)},
         {"value", boundary_in_words(result.beyond_domain[f])}});
  }
}

}  // namespace carom::tool
