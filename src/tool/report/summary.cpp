// SPDX-License-Identifier: BSL-1.0
#include "report/summary.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/properties/trial/in_words.hpp>
#include <carom/subjects/protocol/text.hpp>

#include "report/beyond_domain.hpp"
#include "report/extent.hpp"
#include "report/findings_text.hpp"
#include "report/overall.hpp"
#include "version.hpp"

namespace carom::tool {
namespace {

using properties::GateReport;
using properties::SubjectResult;
using properties::Witness;

constexpr std::size_t longest_summary = 1'000'000;
constexpr std::size_t longest_name = 200;
constexpr std::size_t longest_text = 4000;

/// Text that others chose, as code, in which Markdown reads nothing but the end of a cell.
std::string as_code(const std::string& text, std::size_t longest) {
  std::string code;
  for (const char letter : subjects::protocol::printable_line(text, longest)) {
    if (letter == '|') {
      code += "\\|";
    } else {
      code += letter == '`' ? '\'' : letter;
    }
  }
  return '`' + code + '`';
}

/// Each line moved in, which makes a block of code that no text can end.
std::string as_block(const std::string& text) {
  std::string block;
  bool begins = true;
  for (const char letter : subjects::protocol::printable(text, std::numeric_limits<std::size_t>::max())) {
    block += begins ? "    " : "";
    block += letter;
    begins = letter == '\n';
  }
  return begins ? block : block + '\n';
}

std::string subject_row(const SubjectResult& result, const GateReport& report) {
  const std::string status = status_of(result);
  const std::size_t violated = result.violated_invariants().size();
  const auto worst = result.worst_backward_error(report.options);
  const auto p50 = result.digits_at_least(0.5);
  const std::string digits =
      p50 ? fmt::format("{:.1f} / {:.1f} / {:.1f}", *p50, *result.digits_at_least(0.99), *result.digits_at_least(1))
          : "–";
  return fmt::format(
      "| {} | {} | {} | {} | {} | {} |\n", as_code(result.subject.name, longest_name), name_of(result.subject.model),
      status == "violated" ? fmt::format("**{} violated**", violated) : status, result.cases(),
      determines_outcome(result.subject.model) ? fmt::format("{:.3g}", worst.backward_error) : "–", digits);
}

/// In how many cases of each family anything was violated, those first in which most were.
std::string families_line(const SubjectResult& result, const GateReport& report) {
  std::vector<std::pair<std::uint64_t, std::size_t>> violated;
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    if (result.families[f].violated > 0) {
      violated.emplace_back(result.families[f].violated, f);
    }
  }
  std::stable_sort(violated.begin(), violated.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
  constexpr std::size_t most_named = 8;
  std::string line = fmt::format("In {} of {} families:", violated.size(), result.families.size());
  for (std::size_t i = 0; i < std::min(violated.size(), most_named); ++i) {
    const auto& [count, f] = violated[i];
    line += fmt::format("{} {} ({} of {})", i == 0 ? "" : ",", report.options.families[f]->name, count,
                        result.families[f].cases);
  }
  return line + (violated.size() > most_named ? ", …" : "");
}

std::string violations_of(const GateRun& run, std::size_t s, const std::string& out_directory) {
  const GateReport& report = run.report;
  const SubjectResult& result = report.results[s];
  std::string text = fmt::format("\n### {}\n\n", as_code(result.subject.name, longest_name));
  if (s < run.diagnoses.size() && !run.diagnoses[s].telling.empty()) {
    const properties::diagnosis::Diagnosis& diagnosis = run.diagnoses[s];
    text += as_block(diagnosis.what + '\n' + diagnosis.where + "\nLook at: " + diagnosis.look_at + '\n') + '\n';
  }
  text += "| invariant | violated in | most often in |\n| --- | --- | --- |\n";
  const std::vector<const Witness*> witnesses = witnesses_by_telling(run, s);
  for (const Witness* witness : witnesses) {
    const properties::Count count = result.count(witness->invariant);
    text += fmt::format("| {} | {} of {} cases | {} |\n", witness->invariant, count.violated,
                        count.violated + count.holds, witness->family);
  }
  const Witness& first = *witnesses.front();
  text += fmt::format("\n{}\n\n{} violates {}, of family {}:\n\n", families_line(result, report),
                      as_code(result.subject.name, longest_name), first.invariant, first.family);
  std::string words = fmt::format("{}\n{}", properties::invariant_named(first.invariant)->statement,
                                  properties::violation_in_words(first.shrunk.collision, first.answer, first.verdict));
  if (!out_directory.empty()) {
    const auto file = witness_path(out_directory, result.subject, first);
    words += replay_command(file, result.subject, report.options.yardstick) + '\n';
  }
  return text + as_block(words);
}

}  // namespace

std::string markdown_summary(const GateRun& run, const std::string& out_directory) {
  const GateReport& report = run.report;
  const oracles::Yardstick& yardstick = report.options.yardstick;
  const Overall overall = overall_of(run);
  std::string text = fmt::format(
      "## Carom: {}\n\n{} of {} subjects that count are sound; {}, seed {}, limit {}; Carom {}.\n\n", in_words(overall),
      overall.sound, overall.subjects, extent_of(report.options), report.options.seed,
      yardstick.digits ? fmt::format("{} digits", *yardstick.digits) : fmt::format("{} ulps", yardstick.limit_ulps),
      version);
  if (run.baseline) {
    text += fmt::format("Against the baseline: {}.\n\n", compare::baseline_verdict(*run.baseline));
  }
  if (overall.interrupted) {
    text += "**Interrupted**: this is what was judged until then.\n\n";
  }
  text +=
      "| subject | model | verdict | cases | worst backward error [ulps] | digits p50 / p99 / worst |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  std::vector<std::size_t> counted;
  for (std::size_t s = 0; s < report.results.size(); ++s) {
    if (run.counts[s]) {
      counted.push_back(s);
      text += subject_row(report.results[s], report);
    }
  }
  text += beyond_domain_markdown(run, [](const std::string& name) { return as_code(name, longest_name); });
  std::size_t left_out = 0;
  for (const std::size_t s : counted) {
    const SubjectResult& result = report.results[s];
    std::string section = result.witnesses.empty() ? "" : violations_of(run, s, out_directory);
    const std::string& why = result.error.empty() ? result.not_judged : result.error;
    if (!why.empty()) {
      section += fmt::format("\n{} could not be judged: {}\n", as_code(result.subject.name, longest_name),
                             as_code(why, longest_text));
    }
    const bool fits = text.size() + section.size() <= longest_summary;
    text += fits ? section : "";
    left_out += fits ? 0 : 1;
  }
  if (left_out > 0) {
    text += fmt::format("\nWhat {} subjects more violate is in the report.\n", left_out);
  }
  return text + '\n';
}

}  // namespace carom::tool
