// SPDX-License-Identifier: BSL-1.0
#include "report/findings_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <carom/properties/trial/in_words.hpp>

namespace carom::tool {
namespace {

using properties::GateReport;
using properties::SubjectResult;
using properties::Witness;
using properties::diagnosis::Diagnosis;

/// "in FAMILY (n of m cases), k of all".
std::string extent(const SubjectResult& result, const Witness& witness, const GateReport& report) {
  const auto family = std::find_if(report.options.families.begin(), report.options.families.end(),
                                   [&](const properties::Family* f) { return f->name == witness.family; });
  const auto f = static_cast<std::size_t>(family - report.options.families.begin());
  return fmt::format("in {} ({} of {} cases), {} of all", witness.family,
                     result.families[f].counts.at(witness.invariant).violated, result.families[f].cases,
                     result.count(witness.invariant).violated);
}

std::string replay_line(const SubjectResult& result, const Witness& witness, const GateReport& report,
                        const std::string& out_directory) {
  const auto file = witness_path(out_directory, result.subject, witness);
  return replay_command(file, result.subject, report.options.yardstick);
}

std::string witness_text(const SubjectResult& result, const Witness& witness, const GateReport& report,
                         const std::string& out_directory) {
  std::string text =
      fmt::format("{} violates {} {}\n  {}\n", result.subject.name, witness.invariant, extent(result, witness, report),
                  properties::invariant_named(witness.invariant)->statement);
  text += properties::violation_in_words(witness.shrunk.collision, witness.answer, witness.verdict);
  return out_directory.empty() ? text : text + "  " + replay_line(result, witness, report, out_directory) + '\n';
}

/// The families in which anything was violated, how often, and how far the outcomes are off; those first in which most
/// is.
std::string families_text(const SubjectResult& result, const GateReport& report) {
  struct Share {
    std::size_t family;
    std::uint64_t percent;
  };
  std::vector<Share> shares;
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    const properties::FamilyResult& family = result.families[f];
    if (family.violated > 0) {
      shares.push_back({f, (100 * family.violated + family.cases - 1) / family.cases});
    }
  }
  std::stable_sort(shares.begin(), shares.end(), [](const Share& x, const Share& y) { return x.percent > y.percent; });
  constexpr std::size_t most_named = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(shares.size(), most_named); ++i) {
    const auto& [f, percent] = shares[i];
    text += fmt::format("{}{} {} %", text.empty() ? "" : ", ", report.options.families[f]->name, percent);
    if (determines_outcome(result.subject.model)) {
      text += fmt::format(" ({:.2g})", result.families[f].worst_backward_error);
    }
  }
  return shares.size() > most_named ? fmt::format("{}, and {} families more", text, shares.size() - most_named) : text;
}

std::string diagnosis_text(const Diagnosis& diagnosis) {
  std::string text = "  " + diagnosis.what + '\n';
  text += diagnosis.where.empty() ? "" : "  " + diagnosis.where + '\n';
  return diagnosis.look_at.empty() ? text : text + "  Look at: " + diagnosis.look_at + '\n';
}

}  // namespace

std::vector<const Witness*> witnesses_by_telling(const GateRun& run, std::size_t subject) {
  std::vector<const Witness*> ordered;
  for (const Witness& witness : run.report.results[subject].witnesses) {
    ordered.push_back(&witness);
  }
  if (subject < run.diagnoses.size()) {
    const std::string& telling = run.diagnoses[subject].telling;
    std::stable_partition(ordered.begin(), ordered.end(),
                          [&](const Witness* witness) { return witness->invariant == telling; });
  }
  return ordered;
}

std::string findings_text(const GateRun& run, std::size_t subject, const std::string& out_directory) {
  const SubjectResult& result = run.report.results[subject];
  const std::vector<const Witness*> witnesses = witnesses_by_telling(run, subject);
  std::string text = result.subject.name + '\n';
  if (subject < run.diagnoses.size()) {
    text += diagnosis_text(run.diagnoses[subject]);
  }
  text += "  In: " + families_text(result, run.report) + '\n';
  for (const Witness* witness : witnesses) {
    if (witness == witnesses.front()) {
      text += witness_text(result, *witness, run.report, out_directory);
    } else {
      text += fmt::format("also violates {} {}{}\n", witness->invariant, extent(result, *witness, run.report),
                          out_directory.empty() ? "" : ": " + replay_line(result, *witness, run.report, out_directory));
    }
  }
  return text;
}

}  // namespace carom::tool
