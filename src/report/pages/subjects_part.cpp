// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <carom/properties/features/coverage.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

std::string error_anchor(std::size_t subject) { return fmt::format("error-{}", subject); }

/// Adds the claims that the subject does not make, with the source of each.
void add_deviations(std::vector<std::string>& notes, const Subject& subject,
                    const std::vector<std::string>& of_command_line) {
  std::vector<std::string> own;
  std::vector<std::string> others;
  for (const std::string& deviation : subject.deviates) {
    const bool is_own = std::find(of_command_line.begin(), of_command_line.end(), deviation) == of_command_line.end();
    (is_own ? own : others).push_back(deviation);
  }
  if (!own.empty()) {
    notes.push_back("not claimed by the subject: " + listed(own));
  }
  if (!others.empty()) {
    notes.push_back("not judged because of --deviates: " + listed(others));
  }
  if (const auto of_matrix = properties::not_claimed_without_matrix(subject); !of_matrix.empty()) {
    notes.push_back("not claimed (no collision matrix): " + listed(of_matrix));
  }
}

/// "restitution_threshold in 120 of 4000 colliding cases". Empty if no declared effect decides a case.
std::string decided_cases(const properties::SubjectResult& result, const Run& run) {
  std::uint64_t colliding = 0;
  for (const properties::Coverage& coverage : run.coverage) {
    colliding += coverage.colliding;
  }
  const properties::EffectCounts decided = result.decided_by();
  std::vector<std::string> words;
  for (const DeclaredEffect effect : all_declared_effects) {
    if (decided[effect] > 0) {
      words.push_back(fmt::format("{} in {} of {} colliding cases", name_of(effect), decided[effect], colliding));
    }
  }
  return listed(words);
}

std::string listed_in_short(std::vector<std::string> names) {
  constexpr std::size_t most = 6;
  if (names.size() > most + 1) {
    names[most] = fmt::format("and {} more", names.size() - most);
    names.resize(most + 1);
  }
  return listed(names);
}

/// The notes on a subject, in a text.
std::vector<std::string> notes_on(std::size_t s, const Run& run) {
  const properties::SubjectResult& result = run.results[s];
  const SubjectStatus status = status_of(result);
  std::vector<std::string> notes = ways_on(run, s);
  if (result.skipped() > 0) {
    notes.push_back(fmt::format("{} cases skipped{}{}", result.skipped(), result.answers_alone.empty() ? "" : "; ",
                                result.answers_alone));
  }
  const properties::UnjudgedCounts unjudged = result.unjudged();
  for (const properties::Unjudged reason : properties::all_reasons_unjudged) {
    if (unjudged[reason] > 0) {
      notes.push_back(fmt::format("{} cases not judged: {}", unjudged[reason], in_words(reason)));
    }
  }
  if (!result.error.empty()) {
    notes.push_back(properties::indented("error: " + result.error, "      "));
  } else if (!result.not_judged.empty()) {
    notes.push_back("not judged: " + result.not_judged);
  }
  if (const auto never = never_judged(run, result); status == SubjectStatus::violated && !never.empty()) {
    notes.push_back("never judged: " + listed_in_short(names_of(never)));
  }
  // Under the other laws, an answer without a violation gains no energy.
  if (const std::string energy = energy_in_words(run, s);
      status != SubjectStatus::violated && !determines_outcome(result.subject.law) && !energy.empty()) {
    notes.push_back(energy);
  }
  if (run.options.budget && status == SubjectStatus::sound) {
    notes.push_back(cases_judged(run, result));
  }
  if (const std::string effects = properties::to_text(result.subject.effects); !effects.empty()) {
    notes.push_back("judged without its declared effects: " + effects);
  }
  if (const std::string decided = decided_cases(result, run); !decided.empty()) {
    notes.push_back("decided by a declared effect: " + decided);
  }
  add_deviations(notes, result.subject, run.deviates);
  return notes;
}

Row subject_row(const Run& run, std::size_t s) {
  const properties::SubjectResult& result = run.results[s];
  const SubjectStatus status = status_of(result);
  const properties::Family* const worst = result.worst_backward_error(run.options).family;
  Cell verdict(verdict_in_words(result), fmt::format("verdict {}", name_of(status)));
  const char* const sign = status == SubjectStatus::sound ? "✓" : status == SubjectStatus::violated ? "✗" : "!";
  verdict.sign = sign;
  if (!why_not_judged(result).empty()) {
    verdict.link = '#' + error_anchor(s);
  }
  return {{name_cell(result.subject.name), std::move(verdict), Cell(worst_in_words(run, result), "number"),
           Cell(std::string(worst == nullptr ? no_number : worst->name), "word"),
           Cell(in_words(digits_of(result)), "number"),
           Cell(result.cases() > 0 ? fmt::format("{:.0f}", result.nanoseconds_per_solve) : no_number, "number"),
           Cell(std::to_string(result.cases()), "number"), Cell(std::string(name_of(result.subject.law)), "word"),
           Cell(std::string(name_of(result.subject.precision)), "word")},
          run.counts[s] ? notes_on(s, run) : std::vector<std::string>{},
          false,
          sign};
}

struct Counted {
  const char* name;
  std::uint64_t properties::Coverage::*count;
};

using properties::Coverage;
constexpr std::array counted{Counted{"cases", &Coverage::cases},
                             Counted{"colliding", &Coverage::colliding},
                             Counted{"resting", &Coverage::resting},
                             Counted{"separating", &Coverage::separating},
                             Counted{"inert", &Coverage::inert},
                             Counted{"invalid", &Coverage::invalid},
                             Counted{"one wall", &Coverage::one_immovable},
                             Counted{"spheres", &Coverage::spheres},
                             Counted{"head-on", &Coverage::head_on},
                             Counted{"ε = 0", &Coverage::inelastic},
                             Counted{"ε = 1", &Coverage::elastic}};

Cell number_cell(std::uint64_t number) { return Cell(std::to_string(number), number == 0 ? "number zero" : "number"); }

}  // namespace

void add_subject_rows(Table& table, const Run& run, Subjects which, const std::function<Row(std::size_t)>& row_of) {
  for (const bool counts : {true, false}) {
    bool is_first = true;
    for (std::size_t s = 0; s < run.results.size(); ++s) {
      if (run.counts[s] != counts || (!counts && which == Subjects::counting)) {
        continue;
      }
      if (is_first && !counts) {
        table.rows.push_back({{"Kept because they fail, not counted"}, {}, true});
      }
      is_first = false;
      table.rows.push_back(row_of(s));
    }
  }
}

Table subjects_table(const Run& run, Subjects which) {
  Table table{"Subjects and their verdicts",
              {{"subject"},
               {"verdict", true},
               {"backward error", true},
               {.name = "in family", .is_in_text = false},
               {"digits p50/p99/worst", true},
               {"ns/solve", true},
               {.name = "cases", .is_number = true, .is_in_text = false},
               {.name = "model", .is_in_text = false},
               {.name = "precision", .is_in_text = false}},
              {},
              "subjects"};
  add_subject_rows(table, run, which, [&](std::size_t s) { return subject_row(run, s); });
  if (which == Subjects::counting) {
    return table;
  }
  for (const Subject& subject : run.absent) {
    table.rows.push_back({{name_cell(subject.name), Cell("absent: " + subject.absent, "absent")}});
  }
  return table;
}

Cell command_cell(std::string command) {
  Cell cell(std::move(command));
  cell.is_code = true;
  return cell;
}

Document errors_part(const Run& run) {
  Document document;
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    const std::string& why = why_not_judged(run.results[s]);
    if (!why.empty()) {
      const properties::SubjectResult& result = run.results[s];
      document.emplace_back(
          Section{fmt::format("Why {} {}", result.subject.name,
                              result.error.empty() ? "is not judged" : "could not be judged to the end"),
                  {Code{why}},
                  error_anchor(s),
                  "section",
                  "error"});
    }
  }
  return document;
}

Document energy_part(const Run& run) {
  Facts facts;
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    facts.pairs.emplace_back(run.results[s].subject.name, energy_in_words(run, s));
  }
  std::erase_if(facts.pairs, [](const auto& pair) { return pair.second.text.empty(); });
  return facts.pairs.empty() ? Document{} : Document{std::move(facts)};
}

std::string without_case_in_words(const Run& run) {
  std::vector<std::string> names;
  for (const properties::Family* family : run.without_case) {
    names.emplace_back(family->name);
  }
  return names.empty() ? "" : fmt::format("The domain has no case of {}.", listed(names));
}

Document judge_error_part(const Run& run) {
  if (!run.judge_error) {
    return {};
  }
  return {Section{"The judge failed",
                  {Paragraph{"A fault of the judge ended the run. These are the results before it."},
                   Code{properties::in_words(*run.judge_error)}},
                  "judge-error",
                  "section",
                  "error"}};
}

Table coverage_table(const Run& run) {
  Table table{"Cases of each family, by kind of contact", {{"family"}}, {}};
  for (const Counted& one : counted) {
    table.columns.push_back({one.name, true});
  }
  for (std::size_t f = 0; f < run.coverage.size(); ++f) {
    Cell name{std::string(run.options.families[f]->name)};
    name.small = run.options.families[f]->summary;
    Row row{{std::move(name)}};
    for (const Counted& one : counted) {
      row.cells.push_back(number_cell(run.coverage[f].*one.count));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string features_in_words(const Run& run) {
  const std::string met = fmt::format("{} pairs of features in colliding cases", run.features.met_pairs());
  return run.options.within.is_everything()
             ? fmt::format("{} (20,000 cases of each family have {})", met, properties::pairs_of_long_run)
             : met;
}

Table features_table(const Run& run) {
  Table table{"Number of colliding cases with each feature, over all families",
              {{"feature"}, {"definition"}, {"cases", true}},
              {}};
  for (std::size_t i = 0; i < properties::all_features().size(); ++i) {
    const properties::Feature& feature = properties::all_features()[i];
    table.rows.push_back({{std::string(feature.name), Cell(std::string(feature.statement), "word"),
                           number_cell(run.features.count(i))}});
  }
  return table;
}

}  // namespace carom::report
