// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <span>

#include <fmt/format.h>

#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using properties::SubjectResult;
using properties::Witness;
using properties::diagnosis::Diagnosis;

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

/// The faults. If there are several, each has a number and its own witness.
Facts facts_of(const Run& run, const Subject& subject, const Diagnosis& diagnosis) {
  Facts facts;
  const std::size_t count = diagnosis.faults.size();
  for (std::size_t i = 0; i < count; ++i) {
    const properties::diagnosis::Fault& fault = diagnosis.faults[i];
    facts.pairs.emplace_back(count == 1 ? "what is wrong" : fmt::format("what is wrong, {} of {}", i + 1, count),
                             fault.what);
    facts.pairs.emplace_back("where", fault.where);
    facts.pairs.emplace_back("look at", fault.look_at);
    if (count > 1 && fault.witness) {
      facts.pairs.emplace_back("witness",
                               fmt::format("{} violates {}", replay_command(*fault.witness, run.options, subject),
                                           fault.witness->invariant->name));
    }
  }
  return facts;
}

/// The family of the witness, with the number of its judged cases that violate the invariant.
std::string in_its_family(const Run& run, const SubjectResult& result, const Witness& witness) {
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    const auto count = result.families[f].counts.find(witness.invariant);
    if (run.options.families[f] == witness.family && count != result.families[f].counts.end()) {
      return fmt::format("{} ({})", witness.family->name, violated_of_judged_cases(count->second));
    }
  }
  return std::string(witness.family->name);
}

std::string diagnosis_missing(const Diagnosis& diagnosis) {
  return "the diagnosis is missing, because it failed: " + diagnosis.missing;
}

void add_diagnosis(Document& document, const Run& run, std::size_t s) {
  const Subject& subject = run.results[s].subject;
  const Diagnosis& diagnosis = run.diagnoses[s];
  Facts facts = facts_of(run, subject, diagnosis);
  Cell telling(fmt::format("witness of {}", diagnosis.telling->name));
  telling.link = '#' + witness_anchor(s, *diagnosis.telling);
  facts.pairs.emplace_back("best witness", std::move(telling));
  facts.pairs.emplace_back("its statement", std::string(diagnosis.telling->statement));
  std::vector<const properties::Invariant*> others;
  const std::vector<const Witness*> witnesses = witnesses_by_telling(run, s);
  for (const Witness* witness : witnesses) {
    if (witness->invariant != diagnosis.telling) {
      others.push_back(witness->invariant);
    }
  }
  facts.pairs.emplace_back("also violated", listed(others));
  const Witness& witness = *witnesses.front();
  document.emplace_back(Section{subject.name,
                                {std::move(facts), Code{properties::violation_in_words(
                                                       witness.shrunk.collision, witness.answer, witness.verdict)}},
                                "",
                                "article",
                                "diagnosis"});
}

}  // namespace

std::string not_shrunk_in_words(const Witness& witness) {
  return "The witness is as it was drawn, because its simplification failed: " + witness.not_shrunk;
}

std::string replay_line(const Run& run, const Subject& subject, const Witness& witness,
                        const std::string& out_directory) {
  return replay_command(witness_path(out_directory, subject, *witness.invariant), subject, run.options);
}

Section findings_part(const Run& run, std::size_t s, const std::string& out_directory) {
  const SubjectResult& result = run.results[s];
  const Diagnosis& diagnosis = run.diagnoses[s];
  Document content;
  Facts facts = diagnosis.telling != nullptr ? facts_of(run, result.subject, diagnosis) : Facts{};
  if (!diagnosis.missing.empty()) {
    facts.pairs.emplace_back("what is wrong", diagnosis_missing(diagnosis));
  }
  facts.pairs.emplace_back("in", families_in_words(run, result));
  content.emplace_back(std::move(facts));
  Table table{"", {{"invariant"}, {"violated in"}, {"most often in"}}, {}};
  const std::vector<const Witness*> witnesses = witnesses_by_telling(run, s);
  for (const Witness* witness : witnesses) {
    table.rows.push_back(
        {{std::string(witness->invariant->name), violated_of_judged_cases(result.count(*witness->invariant)),
          in_its_family(run, result, *witness)}});
  }
  content.emplace_back(std::move(table));
  const Witness& first = *witnesses.front();
  content.emplace_back(Paragraph{
      fmt::format("It violates {}, for example in the family {}:", first.invariant->name, first.family->name)});
  std::string words = fmt::format("{}\n{}", first.invariant->statement,
                                  properties::violation_in_words(first.shrunk.collision, first.answer, first.verdict));
  if (!out_directory.empty()) {
    words += replay_line(run, result.subject, first, out_directory) + '\n';
  }
  content.emplace_back(Code{std::move(words)});
  if (!first.not_shrunk.empty()) {
    content.emplace_back(Paragraph{not_shrunk_in_words(first)});
  }
  if (!out_directory.empty() && witnesses.size() > 1) {
    std::string lines;
    for (const Witness* witness : std::span(witnesses).subspan(1)) {
      lines += replay_line(run, result.subject, *witness, out_directory) + '\n';
    }
    content.emplace_back(Paragraph{"To replay the other witnesses:"});
    content.emplace_back(Code{std::move(lines)});
  }
  return {result.subject.name, std::move(content)};
}

Document diagnoses_part(const Run& run) {
  Document document;
  Document kept;
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    const Diagnosis& diagnosis = run.diagnoses[s];
    if (!diagnosis.missing.empty()) {
      document.emplace_back(Section{run.results[s].subject.name, {Paragraph{diagnosis_missing(diagnosis)}}});
    }
    if (diagnosis.telling != nullptr) {
      add_diagnosis(run.counts[s] ? document : kept, run, s);
    }
  }
  if (!kept.empty()) {
    document.emplace_back(Details{"Diagnoses of the subjects that are kept because they fail", std::move(kept)});
  }
  return document;
}

}  // namespace carom::report
