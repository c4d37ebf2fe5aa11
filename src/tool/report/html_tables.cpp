// SPDX-License-Identifier: BSL-1.0
#include "report/html_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "report/adjusted.hpp"
#include "report/markup.hpp"

namespace carom::tool {
namespace {

using properties::SubjectResult;

constexpr const char* none = "–";

pugi::xml_node add_cell(pugi::xml_node row, const std::string& text, const char* look = "number") {
  return add(row, "td", {{"class", look}}, text);
}

/// Calls `row` for each subject: first those that count, then the others, below a heading of their own.
void for_each_subject(pugi::xml_node table, const GateRun& run, std::size_t columns,
                      const std::function<void(pugi::xml_node body, std::size_t subject)>& row) {
  for (const bool counts : {true, false}) {
    if (std::find(run.counts.begin(), run.counts.end(), counts) == run.counts.end()) {
      continue;
    }
    const pugi::xml_node body = add(table, "tbody");
    if (!counts) {
      const pugi::xml_node heading = add(body, "tr", {{"class", "group"}});
      const pugi::xml_node cell = add(heading, "th", {{"scope", "rowgroup"}, {"colspan", std::to_string(columns)}});
      add(cell, "span", {}, "Kept because they fail, not counted");
    }
    for (std::size_t s = 0; s < run.counts.size(); ++s) {
      if (run.counts[s] == counts) {
        row(body, s);
      }
    }
  }
}

pugi::xml_node add_subject_row(pugi::xml_node body, const std::string& name) {
  const pugi::xml_node row = add(body, "tr");
  add(row, "th", {{"scope", "row"}}, name);
  return row;
}

std::string in_digits(const std::optional<double>& digits) { return digits ? fmt::format("{:.1f}", *digits) : none; }

std::string error_anchor(std::size_t subject) { return fmt::format("error-{}", subject); }

void add_subject_cells(pugi::xml_node row, const SubjectResult& result, const properties::GateOptions& options,
                       std::size_t subject) {
  const auto worst = result.worst_backward_error(options);
  const bool has_truth = determines_outcome(result.subject.model);
  const pugi::xml_node verdict = add(row, "td", {{"class", "verdict " + status_of(result)}});
  if (result.error.empty()) {
    add_text(verdict, verdict_in_words(result));
  } else {
    add(verdict, "a", {{"href", '#' + error_anchor(subject)}}, verdict_in_words(result));
  }
  add_cell(row, has_truth ? fmt::format("{:.3g}", worst.backward_error) : none);
  add_cell(row, worst.family.empty() ? none : worst.family, "word");
  for (const double share : {0.5, 0.99, 1.0}) {
    add_cell(row, in_digits(result.digits_at_least(share)));
  }
  add_cell(row, result.cases() > 0 ? fmt::format("{:.0f}", result.nanoseconds_per_solve) : none);
  add_cell(row, std::to_string(result.cases()));
  add_cell(row, std::to_string(result.skipped()));
  add_cell(row, std::string(name_of(result.subject.model)), "word");
  add_cell(row, std::string(name_of(result.subject.precision)), "word");
}

void add_absent(pugi::xml_node table, const GateRun& run, std::size_t columns) {
  if (run.absent.empty()) {
    return;
  }
  const pugi::xml_node body = add(table, "tbody");
  for (const Subject& subject : run.absent) {
    const pugi::xml_node row = add_subject_row(body, subject.name);
    add(row, "td", {{"class", "absent"}, {"colspan", std::to_string(columns - 3)}}, "absent: " + subject.absent);
    add_cell(row, std::string(name_of(subject.model)), "word");
    add_cell(row, std::string(name_of(subject.precision)), "word");
  }
}

void add_errors(pugi::xml_node section, const GateRun& run) {
  for (std::size_t s = 0; s < run.report.results.size(); ++s) {
    const SubjectResult& result = run.report.results[s];
    if (!result.error.empty()) {
      const pugi::xml_node box = add(section, "section", {{"class", "error"}, {"id", error_anchor(s)}});
      add(box, "h3", {}, "Why " + result.subject.name + " could not be judged to the end");
      add(box, "pre", {{"tabindex", "0"}}, result.error);
    }
  }
}

void add_upright_headers(pugi::xml_node table, const char* first, const std::vector<std::string>& names) {
  const pugi::xml_node row = add(add(table, "thead"), "tr");
  add(row, "th", {{"scope", "col"}}, first);
  for (const std::string& name : names) {
    const pugi::xml_node cell = add(row, "th", {{"scope", "col"}, {"class", "upright"}});
    add(cell, "span", {}, name);
  }
}

/// What a cell of the first matrix says: a sign for those who see it, words for those who hear it, and a number.
struct MatrixCell {
  const char* look;
  const char* sign;
  const char* words;
  std::string number;
};

MatrixCell invariant_cell(const SubjectResult& result, const properties::Claim& claim,
                          const properties::Invariant& invariant) {
  const auto claimed = std::find(claim.invariants.begin(), claim.invariants.end(), &invariant);
  if (claimed == claim.invariants.end()) {
    return {"unclaimed", "·", "not claimed", ""};
  }
  const properties::Count count = result.count(std::string(invariant.name));
  if (count.violated > 0) {
    return {"violated", "✗", "violated in", fmt::format("{}", count.violated)};
  }
  return count.holds > 0 ? MatrixCell{"holds", "✓", "holds in", fmt::format("{}", count.holds)}
                         : MatrixCell{"nothing", "○", "no case", ""};
}

/// The shades of the second matrix: up to `limit` times each bound.
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

/// 2.4e14 in place of 2.4e+14: the table is wide enough.
std::string in_few_letters(double number) {
  std::string text = fmt::format("{:.2g}", number);
  std::erase(text, '+');
  return text;
}

const char* shade_of(double backward_error, double limit) {
  const auto found = std::find_if(shades.begin(), shades.end(),
                                  [&](const Shade& shade) { return backward_error <= limit * shade.bound; });
  return found == shades.end() ? shades.back().look : found->look;
}

void add_shades(pugi::xml_node section, double limit) {
  const pugi::xml_node legend = add(section, "ul", {{"class", "legend"}});
  for (std::size_t i = 0; i < shades.size(); ++i) {
    const pugi::xml_node item = add(legend, "li");
    add(item, "span", {{"class", std::string("swatch ") + shades[i].look}, {"aria-hidden", "true"}});
    add_text(item, i + 1 < shades.size() ? fmt::format(" ≤ {:.3g}", limit * shades[i].bound)
                                         : fmt::format(" > {:.3g} ulps", limit * shades[i - 1].bound));
  }
}

}  // namespace

pugi::xml_node add_table(pugi::xml_node section, const std::string& caption, const char* look) {
  // What scrolls must be reached by the keyboard, and then has to say what it is.
  const pugi::xml_node frame =
      add(section, "div", {{"class", "scroll"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", caption}});
  const pugi::xml_node table = add(frame, "table", {{"class", look}});
  add(add(table, "caption"), "span", {}, caption);
  return table;
}

void add_column_headers(pugi::xml_node table, const std::vector<std::string>& names) {
  const pugi::xml_node row = add(add(table, "thead"), "tr");
  for (const std::string& name : names) {
    add(row, "th", {{"scope", "col"}}, name);
  }
}

std::string witness_anchor(std::size_t subject, const std::string& invariant) {
  return fmt::format("witness-{}-{}", subject, invariant);
}

std::string verdict_in_words(const SubjectResult& result) {
  const std::string status = status_of(result);
  if (status == "violated") {
    return fmt::format("✗ {} violated", result.violated_invariants().size());
  }
  return (status == "sound" ? "✓ " : "! ") + status;
}

void add_subjects(pugi::xml_node section, const GateRun& run) {
  const std::vector<std::string> columns{"subject",
                                         "verdict",
                                         "worst backward error [ulps]",
                                         "in family",
                                         "digits: half have",
                                         "99 % have",
                                         "all have",
                                         "ns/solve",
                                         "cases",
                                         "skipped",
                                         "model",
                                         "precision"};
  const pugi::xml_node table = add_table(section, "Subjects and their verdicts", "subjects");
  add_column_headers(table, columns);
  for_each_subject(table, run, columns.size(), [&](pugi::xml_node body, std::size_t s) {
    const SubjectResult& result = run.report.results[s];
    add_subject_cells(add_subject_row(body, result.subject.name), result, run.report.options, s);
  });
  add_absent(table, run, columns.size());
  add_errors(section, run);
}

void add_invariants(pugi::xml_node section, const GateRun& run) {
  std::vector<std::string> names;
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    names.emplace_back(invariant.name);
  }
  add(section, "p", {},
      "✓ holds in so many cases; ✗ violated in so many cases, and linked to a witness; · not claimed by the subject; "
      "○ claimed, and no case in its domain.");
  const pugi::xml_node table = add_table(section, "Invariants: in how many cases each holds or is violated", "matrix");
  add_upright_headers(table, "subject", names);
  for_each_subject(table, run, names.size() + 1, [&](pugi::xml_node body, std::size_t s) {
    const SubjectResult& result = run.report.results[s];
    const pugi::xml_node row = add_subject_row(body, result.subject.name);
    const properties::Claim claim = properties::claim_of(result.subject, run.report.options.yardstick);
    for (const properties::Invariant& invariant : properties::all_invariants()) {
      const MatrixCell cell = invariant_cell(result, claim, invariant);
      const bool is_violated = cell.look == std::string_view("violated");
      pugi::xml_node inside = add(row, "td", {{"class", cell.look}});
      if (is_violated) {
        inside = add(inside, "a", {{"href", '#' + witness_anchor(s, std::string(invariant.name))}});
      }
      add(inside, "span", {{"aria-hidden", "true"}, {"class", "sign"}}, cell.sign);
      add(inside, "span", {{"class", "spoken"}}, std::string(cell.words) + ' ');
      add_text(inside, cell.number);
    }
  });
}

void add_families(pugi::xml_node section, const GateRun& run) {
  const properties::GateOptions& options = run.report.options;
  std::vector<std::string> names;
  for (const properties::Family* family : options.families) {
    names.emplace_back(family->name);
  }
  add(section, "p", {},
      fmt::format("The worst backward error in ulps of the subject's precision. In bold: above the limit of {} ulps.",
                  options.yardstick.limit_ulps));
  add_shades(section, options.yardstick.limit_ulps);
  const pugi::xml_node table = add_table(section, "Families: the worst backward error in each [ulps]", "matrix shaded");
  add_upright_headers(table, "subject", names);
  for_each_subject(table, run, names.size() + 1, [&](pugi::xml_node body, std::size_t s) {
    const SubjectResult& result = run.report.results[s];
    const pugi::xml_node row = add_subject_row(body, result.subject.name);
    for (const properties::FamilyResult& family : result.families) {
      if (family.cases == family.skipped || !determines_outcome(result.subject.model)) {
        const pugi::xml_node cell = add(row, "td", {{"class", "unclaimed"}});
        add(cell, "span", {{"aria-hidden", "true"}}, none);
        add(cell, "span", {{"class", "spoken"}}, "nothing to compare");
        continue;
      }
      const double error = family.worst_backward_error;
      const bool is_above = !(error <= options.yardstick.limit_ulps);
      add(row, "td",
          {{"class", std::string(shade_of(error, options.yardstick.limit_ulps)) + (is_above ? " above" : "")}},
          in_few_letters(error));
    }
  });
}

void add_coverage(pugi::xml_node section, const GateRun& run) {
  const pugi::xml_node table = add_table(section, "Cases of each family, by what happens in them", "coverage");
  add_column_headers(table, {"family", "cases", "colliding", "resting", "separating", "both immovable", "invalid",
                             "one immovable", "spheres", "head-on", "ε = 0", "ε = 1"});
  const pugi::xml_node body = add(table, "tbody");
  for (std::size_t f = 0; f < run.report.coverage.size(); ++f) {
    const properties::Coverage& c = run.report.coverage[f];
    const pugi::xml_node row = add(body, "tr");
    const pugi::xml_node header = add(row, "th", {{"scope", "row"}});
    add_text(header, run.report.options.families[f]->name);
    add(header, "small", {}, run.report.options.families[f]->summary);
    for (const std::uint64_t number : {c.cases, c.colliding, c.resting, c.separating, c.inert, c.invalid,
                                       c.one_immovable, c.spheres, c.head_on, c.inelastic, c.elastic}) {
      add_cell(row, std::to_string(number), number == 0 ? "number zero" : "number");
    }
  }
  add(section, "p", {}, adjusted_sentences(run.report));
}

void add_features(pugi::xml_node section, const GateRun& run) {
  const properties::FeatureCoverage& coverage = run.report.features;
  const auto missing = coverage.missing_pairs();
  const std::uint64_t feasible = coverage.feasible_pairs();
  std::string text =
      fmt::format("{} of the {} pairs of features that a collision can have came up together in colliding cases",
                  feasible - missing.size(), feasible);
  constexpr std::size_t most_named = 20;
  for (std::size_t i = 0; i < std::min(missing.size(), most_named); ++i) {
    text += fmt::format("{} {} with {}", i == 0 ? "; missing:" : ",", missing[i].x->name, missing[i].y->name);
  }
  add(section, "p", {}, text + (missing.size() > most_named ? ", …" : "."));
  const pugi::xml_node details = add(section, "details");
  add(details, "summary", {}, "In how many colliding cases each feature was");
  const pugi::xml_node table = add_table(details, "Colliding cases of all families by their features", "coverage");
  add_column_headers(table, {"feature", "what holds", "cases"});
  const pugi::xml_node body = add(table, "tbody");
  for (std::size_t i = 0; i < properties::all_features().size(); ++i) {
    const properties::Feature& feature = properties::all_features()[i];
    const pugi::xml_node row = add_subject_row(body, feature.name);
    add_cell(row, feature.statement, "word");
    add_cell(row, std::to_string(coverage.count(i)), coverage.count(i) == 0 ? "number zero" : "number");
  }
}

}  // namespace carom::tool
