// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include <carom/report/pages/parts.hpp>
#include <carom/report/pictures/markup.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using properties::FamilyResult;
using properties::SubjectResult;

/// A matrix with a row for each subject. The subjects that count are first, and the others follow below a heading.
template <class OfSubject>
Table matrix(const Run& run, const char* caption, const char* look, const std::vector<std::string>& names,
             const OfSubject& cell_of) {
  Table table{caption, {{"subject"}}, {}, look};
  for (const std::string& name : names) {
    table.columns.push_back({name, true, true});
  }
  add_subject_rows(table, run, Subjects::all, [&](std::size_t s) {
    Row row{{run.results[s].subject.name}};
    for (std::size_t column = 0; column < names.size(); ++column) {
      row.cells.push_back(cell_of(s, column));
    }
    return row;
  });
  return table;
}

/// A cell with a visible sign, its words for screen readers, and a number.
Cell signed_cell(const char* look, const char* sign, const char* spoken, std::string number = {}) {
  Cell cell(std::move(number), look);
  cell.sign = sign;
  cell.spoken = spoken;
  return cell;
}

Cell invariant_cell(const Run& run, std::size_t s, const properties::Invariant& invariant) {
  const SubjectResult& result = run.results[s];
  const properties::Claim claim = properties::claim_of(result.subject, run.options.limits);
  if (std::find(claim.invariants.begin(), claim.invariants.end(), &invariant) == claim.invariants.end()) {
    return signed_cell("unclaimed", "·", "not claimed");
  }
  const properties::Count count = result.count(invariant);
  if (count.violated > 0) {
    Cell cell = signed_cell("violated", "✗", "violated in", std::to_string(count.violated));
    cell.link = '#' + witness_anchor(s, invariant);
    return cell;
  }
  return count.holds > 0 ? signed_cell("holds", "✓", "holds in", std::to_string(count.holds))
                         : signed_cell("nothing", "○", "no case");
}

/// The shades of the matrix of backward errors. Each shade is for errors up to `bound` times the limit of the
/// yardstick.
struct Shade {
  const char* look;
  double bound;
};
constexpr std::array<Shade, 8> shades{{{"shade-0", 1.0 / 32},
                                       {"shade-1", 0.25},
                                       {"shade-2", 1},
                                       {"shade-3", 1e3},
                                       {"shade-4", 1e6},
                                       {"shade-5", 1e9},
                                       {"shade-6", 1e12},
                                       {"shade-7", std::numeric_limits<double>::infinity()}}};

/// Writes 2.4e14 in place of 2.4e+14, because the table is wide already.
std::string in_few_letters(double number) {
  std::string text = fmt::format("{:.2g}", number);
  std::erase(text, '+');
  return text;
}

std::string shade_of(double backward_error, double limit) {
  const auto found = std::find_if(shades.begin(), shades.end(),
                                  [&](const Shade& shade) { return backward_error <= limit * shade.bound; });
  return found == shades.end() ? shades.back().look : found->look;
}

void draw_shades(pugi::xml_node section, double limit) {
  const pugi::xml_node legend = add(section, "ul", {{"class", "legend"}});
  for (std::size_t i = 0; i < shades.size(); ++i) {
    const pugi::xml_node item = add(legend, "li");
    add(item, "span", {{"class", std::string("swatch ") + shades[i].look}, {"aria-hidden", "true"}});
    add_text(item, i + 1 < shades.size() ? fmt::format(" ≤ {:.3g}", limit * shades[i].bound)
                                         : fmt::format(" > {:.3g} ulps", limit * shades[i - 1].bound));
  }
}

Cell backward_error_cell(const SubjectResult& result, const FamilyResult& family, double limit) {
  if (family.cases == family.skipped || !determines_outcome(result.subject.law)) {
    return signed_cell("unclaimed", no_number, "no outcome to compare with");
  }
  const double error = family.worst_backward_error;
  return Cell(in_few_letters(error), shade_of(error, limit) + (error <= limit ? "" : " above"));
}

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

Document invariants_part(const Run& run) {
  const auto all = properties::all_invariants();
  std::vector<std::string> names;
  for (const properties::Invariant& invariant : all) {
    names.emplace_back(invariant.name);
  }
  return {Paragraph{
              "✓ and the number of cases in which it holds; ✗ and the number of cases that violate it, with a link to "
              "a witness; · the subject does not claim it; ○ the subject claims it, but no case is in its domain."},
          matrix(run, "Invariants: the number of cases in which each holds or is violated", "matrix", names,
                 [&](std::size_t s, std::size_t i) { return invariant_cell(run, s, all[i]); })};
}

Document families_part(const Run& run) {
  const double limit = run.options.limits.limit_ulps;
  std::vector<std::string> names;
  for (const properties::Family* family : run.options.families) {
    names.emplace_back(family->name);
  }
  return {Paragraph{fmt::format("The table shows the worst backward error in ulps of the subject's precision. Bold "
                                "numbers are above the limit of {} ulps.",
                                limit)},
          Picture{[limit](pugi::xml_node section) { draw_shades(section, limit); }},
          matrix(run, "Families: the worst backward error in each [ulps]", "matrix shaded", names,
                 [&](std::size_t s, std::size_t f) {
                   const SubjectResult& result = run.results[s];
                   return backward_error_cell(result, result.families[f], limit);
                 })};
}

Document deviations_part(const Run& run) {
  Table table{"Invariants that are not claimed", {{"subject"}, {"invariant"}, {"why"}}, {}};
  const auto add_row = [&](const Subject& subject, std::string invariant, const char* why) {
    table.rows.push_back({{subject.name, Cell(std::move(invariant), "word"), Cell(why, "word")}});
  };
  const std::vector<std::string>& of_command_line = run.deviates;
  for (const SubjectResult& result : run.results) {
    const Subject& subject = result.subject;
    for (const std::string& deviation : subject.deviates) {
      const bool is_own = std::find(of_command_line.begin(), of_command_line.end(), deviation) == of_command_line.end();
      add_row(subject, deviation, is_own ? "the subject does not claim it" : "option --deviates");
    }
    for (const properties::Invariant* invariant : properties::not_claimed_without_matrix(subject)) {
      add_row(subject, std::string(invariant->name), shows_no_matrix);
    }
  }
  if (table.rows.empty()) {
    return {};
  }
  return {Section{"Not claimed",
                  {Paragraph{"The gate did not judge these invariants, so the report says nothing about them. "
                             "NAME@FAMILY is not claimed in that family only."},
                   std::move(table)},
                  "",
                  "div"}};
}

Document never_judged_part(const Run& run) {
  Table table{"Claimed invariants that no case judged", {{"subject"}, {"invariants"}}, {}};
  for (const SubjectResult& result : run.results) {
    if (const auto never = never_judged(run, result); !never.empty()) {
      table.rows.push_back({{result.subject.name, Cell(listed(never), "word")}});
    }
  }
  if (table.rows.empty()) {
    return {};
  }
  return {Section{"Never judged", {std::move(table)}, "", "div"}};
}

std::string boundary_in_words(const FamilyResult& family) {
  if (family.judged() == 0) {
    return no_number;
  }
  return family.boundary
             ? fmt::format("from {:.2g}: {} of {}", family.boundary->quantity, family.violated, family.judged())
             : fmt::format("nowhere, of {}", family.judged());
}

Document beyond_domain_part(const Run& run, Subjects which) {
  Table table{"Limits of each subject beyond the claimed domain", {{"subject"}}, {}};
  for (const properties::Family* family : run.options.beyond_domain) {
    table.columns.push_back({fmt::format("{} ({})", family->name, family->beyond.name)});
  }
  bool was_posed = false;
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    const SubjectResult& result = run.results[s];
    was_posed = was_posed || !result.beyond_domain.empty();
    if (!run.counts[s] && which == Subjects::counting) {
      continue;
    }
    Row row{{result.subject.name}};
    for (const FamilyResult& family : result.beyond_domain) {
      row.cells.emplace_back(boundary_in_words(family), "word");
    }
    row.cells.resize(run.options.beyond_domain.size() + 1, Cell(no_number));
    table.rows.push_back(std::move(row));
  }
  if (!was_posed) {
    return {};
  }
  return {Section{
      "Beyond the claimed domain",
      {Paragraph{"The table shows the least value of the quantity at which the subject violates an invariant, and the "
                 "number of violated cases of all judged cases. The verdicts and the exit status do not depend on it."},
       std::move(table)},
      "",
      "div"}};
}

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
