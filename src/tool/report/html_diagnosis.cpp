// SPDX-License-Identifier: BSL-1.0
#include "report/html_diagnosis.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <carom/properties/trial/in_words.hpp>

#include "report/findings_text.hpp"
#include "report/html_tables.hpp"
#include "report/markup.hpp"

namespace carom::tool {
namespace {

using properties::FamilyResult;
using properties::SubjectResult;
using properties::diagnosis::Diagnosis;

void add_line(pugi::xml_node list, const char* name, const std::string& text) {
  if (!text.empty()) {
    const pugi::xml_node line = add(list, "div");
    add(line, "dt", {}, name);
    add(line, "dd", {}, text);
  }
}

void add_diagnosis(pugi::xml_node section, const GateRun& run, std::size_t s) {
  const SubjectResult& result = run.report.results[s];
  const Diagnosis& diagnosis = run.diagnoses[s];
  const pugi::xml_node card = add(section, "article", {{"class", "diagnosis"}});
  add(card, "h3", {}, result.subject.name);
  const pugi::xml_node list = add(card, "dl");
  add_line(list, "what is wrong", diagnosis.what);
  add_line(list, "where", diagnosis.where);
  add_line(list, "look at", diagnosis.look_at);
  const pugi::xml_node line = add(list, "div");
  add(line, "dt", {}, "tells most");
  const pugi::xml_node telling = add(line, "dd");
  add(telling, "a", {{"href", '#' + witness_anchor(s, diagnosis.telling)}}, "witness of " + diagnosis.telling);
  add_text(telling, fmt::format(": {}", properties::invariant_named(diagnosis.telling)->statement));
  std::string others;
  for (const properties::Witness* witness : witnesses_by_telling(run, s)) {
    if (witness->invariant != diagnosis.telling) {
      others += (others.empty() ? "" : ", ") + witness->invariant;
    }
  }
  add_line(list, "also violated", others);
  const properties::Witness& witness = *witnesses_by_telling(run, s).front();
  add(card, "pre", {{"tabindex", "0"}},
      properties::violation_in_words(witness.shrunk.collision, witness.answer, witness.verdict));
}

std::vector<std::string> violated_in_order(const GateRun& run, std::size_t s) {
  std::vector<std::string> names;
  for (const properties::Witness* witness : witnesses_by_telling(run, s)) {
    names.push_back(witness->invariant);
  }
  return names;
}

void add_headers(pugi::xml_node table, const char* first, const std::vector<std::string>& names) {
  const pugi::xml_node row = add(add(table, "thead"), "tr");
  add(row, "th", {{"scope", "col"}}, first);
  for (const std::string& name : names) {
    add(add(row, "th", {{"scope", "col"}, {"class", "upright"}}), "span", {}, name);
  }
}

/// "12 of 1000, #7", the worst case's number linked to the witness where it is of this family.
void add_family_cell(pugi::xml_node row, const GateRun& run, std::size_t s, std::size_t f,
                     const std::string& invariant) {
  const SubjectResult& result = run.report.results[s];
  const FamilyResult& family = result.families[f];
  const auto count = family.counts.find(invariant);
  const std::uint64_t judged = count == family.counts.end() ? 0 : count->second.holds + count->second.violated;
  if (judged == 0) {
    add(row, "td", {{"class", "nothing"}}, "○");
    return;
  }
  if (count->second.violated == 0) {
    add(row, "td", {{"class", "holds"}}, "✓");
    return;
  }
  const pugi::xml_node cell = add(row, "td", {{"class", "violated"}});
  add_text(cell, fmt::format("{} of {}, ", count->second.violated, judged));
  const std::string number = fmt::format("#{}", family.worst.at(invariant).index);
  const std::string name(run.report.options.families[f]->name);
  const bool has_witness = std::any_of(result.witnesses.begin(), result.witnesses.end(), [&](const auto& witness) {
    return witness.invariant == invariant && witness.family == name;
  });
  if (has_witness) {
    add(cell, "a", {{"href", '#' + witness_anchor(s, invariant)}}, number);
  } else {
    add_text(cell, number);
  }
}

void add_family_matrix(pugi::xml_node section, const GateRun& run, std::size_t s) {
  const SubjectResult& result = run.report.results[s];
  const std::vector<std::string> names = violated_in_order(run, s);
  const pugi::xml_node table =
      add_table(section, result.subject.name + ": violated cases of those judged, and the worst one", "matrix");
  add_headers(table, "family", names);
  const pugi::xml_node body = add(table, "tbody");
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    if (result.families[f].violated == 0) {
      continue;
    }
    const pugi::xml_node row = add(body, "tr");
    add(row, "th", {{"scope", "row"}}, run.report.options.families[f]->name);
    for (const std::string& name : names) {
      add_family_cell(row, run, s, f, name);
    }
  }
}

/// Of one feature, how many sampled cases have it, and how many of them violate each invariant.
struct FeatureRow {
  std::size_t feature = 0;
  std::uint64_t cases = 0;
  std::uint64_t violated = 0;  // anything
  std::vector<std::uint64_t> by_invariant;

  [[nodiscard]] double share() const { return static_cast<double>(violated) / static_cast<double>(cases); }
};

std::vector<FeatureRow> feature_rows(const GateRun& run, std::size_t s, const std::vector<std::string>& names) {
  const SubjectResult& result = run.report.results[s];
  std::vector<FeatureRow> rows(properties::all_features().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].feature = i;
    rows[i].by_invariant.resize(names.size());
  }
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    std::vector<const std::vector<std::uint64_t>*> violated;
    static const std::vector<std::uint64_t> none;
    for (const std::string& name : names) {
      const auto found = result.families[f].violated_cases.find(name);
      violated.push_back(found == result.families[f].violated_cases.end() ? &none : &found->second);
    }
    const auto& sampled = run.report.sampled[f];
    for (std::size_t number = 0; number < sampled.size(); ++number) {
      std::vector<bool> violates;
      for (const auto* numbers : violated) {
        violates.push_back(std::binary_search(numbers->begin(), numbers->end(), number));
      }
      const bool is_any = std::find(violates.begin(), violates.end(), true) != violates.end();
      for (const std::uint16_t feature : sampled[number].features) {
        FeatureRow& row = rows[feature];
        ++row.cases;
        row.violated += is_any ? 1 : 0;
        for (std::size_t i = 0; i < violates.size(); ++i) {
          row.by_invariant[i] += violates[i] ? 1 : 0;
        }
      }
    }
  }
  return rows;
}

void add_feature_matrix(pugi::xml_node section, const GateRun& run, std::size_t s) {
  const std::vector<std::string> names = violated_in_order(run, s);
  std::vector<FeatureRow> rows = feature_rows(run, s, names);
  std::erase_if(rows, [](const FeatureRow& row) { return row.violated == 0; });
  std::stable_sort(rows.begin(), rows.end(),
                   [](const FeatureRow& x, const FeatureRow& y) { return x.share() > y.share(); });
  constexpr std::size_t most_rows = 40;
  rows.resize(std::min(rows.size(), most_rows));
  const pugi::xml_node details = add(section, "details");
  add(details, "summary", {}, "By feature: the " + std::to_string(rows.size()) + " that violated cases have most");
  const pugi::xml_node table = add_table(
      details, run.report.results[s].subject.name + ": violated cases among the sampled ones with a feature", "matrix");
  std::vector<std::string> columns{"cases", "violated"};
  columns.insert(columns.end(), names.begin(), names.end());
  add_headers(table, "feature", columns);
  const pugi::xml_node body = add(table, "tbody");
  for (const FeatureRow& of_feature : rows) {
    const properties::Feature& feature = properties::all_features()[of_feature.feature];
    const pugi::xml_node row = add(body, "tr");
    const pugi::xml_node header = add(row, "th", {{"scope", "row"}});
    add_text(header, feature.name);
    add(header, "small", {}, feature.statement);
    add(row, "td", {{"class", "number"}}, std::to_string(of_feature.cases));
    add(row, "td", {{"class", "number"}}, std::to_string(of_feature.violated));
    for (const std::uint64_t count : of_feature.by_invariant) {
      add(row, "td", {{"class", count > 0 ? "violated" : "holds"}}, std::to_string(count));
    }
  }
}

bool has_diagnosis(const GateRun& run, std::size_t s) {
  return s < run.diagnoses.size() && !run.diagnoses[s].telling.empty();
}

}  // namespace

void add_diagnoses(pugi::xml_node section, const GateRun& run) {
  pugi::xml_node kept;
  for (const bool counts : {true, false}) {
    for (std::size_t s = 0; s < run.report.results.size(); ++s) {
      if (run.counts[s] != counts || !has_diagnosis(run, s)) {
        continue;
      }
      if (!counts && !kept) {
        kept = add(section, "details");
        add(kept, "summary", {}, "What is wrong with the subjects that are kept because they fail");
      }
      add_diagnosis(counts ? section : kept, run, s);
    }
  }
}

void add_violation_matrices(pugi::xml_node section, const GateRun& run) {
  bool any = false;
  for (std::size_t s = 0; s < run.report.results.size(); ++s) {
    if (run.counts[s] && has_diagnosis(run, s)) {
      any = true;
      add_family_matrix(section, run, s);
      add_feature_matrix(section, run, s);
    }
  }
  if (any) {
    add(section, "p", {},
        "To replay a case by its number: carom replay --family FAMILY --case NUMBER --seed SEED --subject SUBJECT.");
  } else {
    add(section, "p", {}, "No subject that counts violates anything.");
  }
}

}  // namespace carom::tool
