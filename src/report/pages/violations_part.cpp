// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <fmt/format.h>

#include <carom/report/pages/parts.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using properties::FamilyResult;
using properties::SubjectResult;

using Invariants = std::vector<const properties::Invariant*>;

Invariants violated_in_order(const Run& run, std::size_t s) {
  Invariants violated;
  for (const properties::Witness* witness : witnesses_by_telling(run, s)) {
    violated.push_back(witness->invariant);
  }
  return violated;
}

void add_upright(Table& table, const Invariants& invariants) {
  for (const std::string& name : names_of(invariants)) {
    table.columns.push_back({name, true, true});
  }
}

/// "12 of 1000, #7". #7 is the worst case. It links to the witness if the witness is of this family.
Cell family_cell(const Run& run, std::size_t s, std::size_t f, const properties::Invariant& invariant) {
  const SubjectResult& result = run.results[s];
  const FamilyResult& family = result.families[f];
  const auto count = family.counts.find(&invariant);
  if (count == family.counts.end() || count->second.judged() == 0) {
    return Cell("○", "nothing");
  }
  if (count->second.violated == 0) {
    return Cell("✓", "holds");
  }
  Cell cell(fmt::format("#{}", family.worst.at(&invariant).index), "violated");
  cell.before = violated_of_judged(count->second) + ", ";
  const bool has_witness = std::any_of(result.witnesses.begin(), result.witnesses.end(), [&](const auto& witness) {
    return witness.invariant == &invariant && witness.family == run.options.families[f];
  });
  cell.link = has_witness ? '#' + witness_anchor(s, invariant) : "";
  return cell;
}

Table family_matrix(const Run& run, std::size_t s) {
  const SubjectResult& result = run.results[s];
  const Invariants violated = violated_in_order(run, s);
  Table table{
      result.subject.name + ": number of violated and judged cases, and the worst case", {{"family"}}, {}, "matrix"};
  add_upright(table, violated);
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    if (result.families[f].violated == 0) {
      continue;
    }
    Row row{{std::string(run.options.families[f]->name)}};
    for (const properties::Invariant* invariant : violated) {
      row.cells.push_back(family_cell(run, s, f, *invariant));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// The number of sampled cases (sample.hpp) with a feature, and how many of these violate each invariant.
struct FeatureRow {
  std::size_t feature = 0;
  std::uint64_t cases = 0;
  std::uint64_t violated = 0;  // any invariant
  std::vector<std::uint64_t> by_invariant;

  [[nodiscard]] double share() const { return static_cast<double>(violated) / static_cast<double>(cases); }
};

std::vector<FeatureRow> feature_rows(const Run& run, const SubjectResult& result, const Invariants& invariants) {
  std::vector<FeatureRow> rows(properties::all_features().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].feature = i;
    rows[i].by_invariant.resize(invariants.size());
  }
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    std::vector<const std::vector<std::uint64_t>*> violated;
    static const std::vector<std::uint64_t> none;
    for (const properties::Invariant* invariant : invariants) {
      const auto found = result.families[f].violated_cases.find(invariant);
      violated.push_back(found == result.families[f].violated_cases.end() ? &none : &found->second);
    }
    const auto& sampled = run.sampled[f];
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

Details feature_matrix(const Run& run, std::size_t s) {
  const SubjectResult& result = run.results[s];
  const Invariants violated = violated_in_order(run, s);
  std::vector<FeatureRow> rows = feature_rows(run, result, violated);
  std::erase_if(rows, [](const FeatureRow& row) { return row.violated == 0; });
  std::stable_sort(rows.begin(), rows.end(),
                   [](const FeatureRow& x, const FeatureRow& y) { return x.share() > y.share(); });
  constexpr std::size_t most_rows = 40;
  rows.resize(std::min(rows.size(), most_rows));
  Table table{result.subject.name + ": sampled cases with each feature, and the violated ones among them",
              {{"feature"}, {"cases", true}, {"violated", true}},
              {},
              "matrix"};
  add_upright(table, violated);
  for (const FeatureRow& of_feature : rows) {
    const properties::Feature& feature = properties::all_features()[of_feature.feature];
    Cell name{std::string(feature.name)};
    name.small = feature.statement;
    Row row{{std::move(name), Cell(std::to_string(of_feature.cases), "number"),
             Cell(std::to_string(of_feature.violated), "number")}};
    for (const std::uint64_t count : of_feature.by_invariant) {
      row.cells.emplace_back(std::to_string(count), count > 0 ? "violated" : "holds");
    }
    table.rows.push_back(std::move(row));
  }
  return {fmt::format("The {} most frequent features of violated cases", rows.size()), {std::move(table)}};
}

}  // namespace

Document violations_part(const Run& run) {
  Document document;
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    if (run.counts[s] && run.diagnoses[s].telling != nullptr) {
      document.emplace_back(family_matrix(run, s));
      document.emplace_back(feature_matrix(run, s));
    }
  }
  document.emplace_back(
      Paragraph{document.empty() ? "No subject that counts violates an invariant."
                                 : fmt::format("To replay a case by its number: carom replay --family FAMILY --case "
                                               "NUMBER --seed SEED{} --subject SUBJECT.",
                                               within_option(run.options.within))});
  return document;
}

}  // namespace carom::report
