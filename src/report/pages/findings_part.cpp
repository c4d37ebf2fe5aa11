// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/properties/diagnosis/where.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/pages/short_case.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using properties::SubjectResult;
using properties::Witness;
using properties::diagnosis::Diagnosis;
using properties::diagnosis::Fault;

/// The families with violations, the largest share of judged cases first. Each has its share and its worst backward
/// error. Invalid collisions have no backward error.
std::string families_in_words(const Run& run, const SubjectResult& result) {
  struct Share {
    std::size_t family;
    std::uint64_t percent;
  };
  std::vector<Share> shares;
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    const properties::FamilyResult& family = result.families[f];
    if (family.violated > 0) {
      shares.push_back({f, (100 * family.violated + family.judged() - 1) / family.judged()});
    }
  }
  std::stable_sort(shares.begin(), shares.end(), [](const Share& x, const Share& y) { return x.percent > y.percent; });
  constexpr std::size_t most_named = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(shares.size(), most_named); ++i) {
    const auto& [f, percent] = shares[i];
    text += fmt::format("{}{} % of {}{}", i == 0 ? "" : ", ", percent, i == 0 ? "the judged cases of " : "",
                        run.options.families[f]->name);
    if (const double error = result.families[f].worst_backward_error; error > 0) {
      text += fmt::format(" (backward error up to {:.2g} ulps)", error);
    }
  }
  return shares.size() > most_named ? fmt::format("{}, and {} more families", text, shares.size() - most_named) : text;
}

std::string sentence_of(const Fault& fault) { return properties::diagnosis::in_one_sentence(fault.what, fault.where); }

/// The faults after the first one.
void add_other_faults(Facts& facts, const Run& run, std::size_t s, Form form) {
  const std::vector<Fault>& faults = run.diagnoses[s].faults;
  for (std::size_t i = 1; i < faults.size(); ++i) {
    const Fault& fault = faults[i];
    const bool is_short = form == Form::terminal;
    const std::string place = is_short && fault.witness
                                  ? fmt::format(" (case {} of {})", fault.witness->index, fault.witness->family->name)
                                  : "";
    facts.pairs.emplace_back("Also", sentence_of(fault) + place);
    if (!is_short) {
      facts.pairs.emplace_back("Look at", fault.look_at);
      facts.pairs.emplace_back(
          "Replay",
          fault.witness ? command_cell(replay_command(*fault.witness, run.options, run.results[s].subject)) : Cell());
    }
  }
}

std::string violated_in_words(const SubjectResult& result, const std::vector<const Witness*>& witnesses) {
  std::vector<std::string> words;
  for (const Witness* witness : witnesses) {
    const properties::Count count = result.count(*witness->invariant);
    words.push_back(fmt::format("{} in {}", witness->invariant->name,
                                words.empty() ? violated_of_judged_cases(count) : violated_of_judged(count)));
  }
  return listed(words);
}

/// The witness for a first look: of the invariant that explains most, but of a shown matrix only if no other is wrong.
const Witness& first_of(const std::vector<const Witness*>& witnesses) {
  const auto found = std::find_if(witnesses.begin(), witnesses.end(),
                                  [](const Witness* witness) { return !witness->invariant->is_of_matrix(); });
  return found == witnesses.end() ? *witnesses.front() : **found;
}

}  // namespace

std::string not_shrunk_in_words(const Witness& witness) {
  return "The witness is as it was drawn, because its simplification failed: " + witness.not_shrunk;
}

std::string replay_line(const Run& run, const Subject& subject, const Witness& witness,
                        const std::string& out_directory) {
  return out_directory.empty()
             ? replay_command({witness.family, witness.index, witness.invariant}, run.options, subject)
             : replay_command(witness_path(out_directory, subject, *witness.invariant), subject, run.options);
}

Section finding_part(const Run& run, std::size_t s, const std::string& out_directory, Form form) {
  const SubjectResult& result = run.results[s];
  const Diagnosis& diagnosis = run.diagnoses[s];
  const std::vector<const Witness*> witnesses = witnesses_by_telling(run, s);
  const Witness& first = first_of(witnesses);
  Document content;
  if (!diagnosis.faults.empty()) {
    content.emplace_back(Paragraph{sentence_of(diagnosis.faults.front()), "fault"});
  }
  if (!diagnosis.missing.empty()) {
    content.emplace_back(Paragraph{"The diagnosis is missing, because it failed: " + diagnosis.missing});
  }
  content.emplace_back(Code{short_case(first, result.subject)});
  if (!first.not_shrunk.empty()) {
    content.emplace_back(Paragraph{not_shrunk_in_words(first)});
  }
  Facts facts;
  facts.pairs.emplace_back("Look at", diagnosis.faults.empty() ? "" : diagnosis.faults.front().look_at);
  facts.pairs.emplace_back("Replay", command_cell(replay_line(run, result.subject, first, out_directory)));
  if (form == Form::page) {
    Cell whole(fmt::format("the witness of {}", first.invariant->name));
    whole.link = '#' + witness_anchor(s, *first.invariant);
    facts.pairs.emplace_back("In full", std::move(whole));
  }
  add_other_faults(facts, run, s, form);
  facts.pairs.emplace_back("Violated", violated_in_words(result, witnesses));
  facts.pairs.emplace_back("Energy", energy_in_words(run, s));
  if (form != Form::terminal) {
    facts.pairs.emplace_back("Families", families_in_words(run, result));
    for (const std::string& way : ways_on(run, s)) {
      facts.pairs.emplace_back("Way on", way);
    }
  }
  content.emplace_back(std::move(facts));
  return {"What is wrong with " + result.subject.name, std::move(content), "", "article", "diagnosis"};
}

Document findings_part(const Run& run, const std::string& out_directory) {
  Document document;
  Document kept;
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    if (!run.results[s].witnesses.empty()) {
      (run.counts[s] ? document : kept).emplace_back(finding_part(run, s, out_directory, Form::page));
    }
  }
  if (!kept.empty()) {
    document.emplace_back(Details{"Faults of the subjects that are kept because they fail", std::move(kept)});
  }
  return document;
}

Document violated_families_part(const Run& run) {
  Facts facts;
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    if (run.counts[s] && !run.results[s].witnesses.empty()) {
      facts.pairs.emplace_back(run.results[s].subject.name, families_in_words(run, run.results[s]));
    }
  }
  return facts.pairs.empty() ? Document{}
                             : Document{Section{"Families with violations", {std::move(facts)}, "", "div"}};
}

}  // namespace carom::report
