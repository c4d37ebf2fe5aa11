// SPDX-License-Identifier: BSL-1.0
#include "report/annotations.hpp"

#include <string_view>

#include <fmt/format.h>

#include <carom/properties/trial/in_words.hpp>
#include <carom/subjects/protocol/text.hpp>

#include "report/extent.hpp"
#include "report/findings_text.hpp"
#include "report/overall.hpp"

namespace carom::tool {
namespace {

using properties::SubjectResult;
using properties::Witness;

constexpr std::size_t longest_title = 200;
constexpr std::size_t longest_message = 4000;

/// What ends a command or one of its fields is written as % and two digits; `ends` has what else does than a line end.
std::string escaped(std::string_view text, std::string_view ends) {
  std::string result;
  for (const char letter : text) {
    if (letter == '%' || letter == '\r' || letter == '\n' || ends.find(letter) != std::string_view::npos) {
      result += fmt::format("%{:02X}", static_cast<unsigned char>(letter));
    } else {
      result += letter;
    }
  }
  return result;
}

std::string command(std::string_view name, const std::string& title, const std::string& message) {
  using subjects::protocol::printable;
  using subjects::protocol::printable_line;
  return fmt::format("::{} title={}::{}\n", name, escaped(printable_line(title, longest_title), ":,"),
                     escaped(printable(message, longest_message), ""));
}

std::string violation(const GateRun& run, const SubjectResult& result, const Witness& witness,
                      const std::string& out_directory) {
  const properties::Count count = result.count(witness.invariant);
  std::string message = fmt::format(
      "{} of {} cases, most often in {}. {}\n{}", count.violated, count.violated + count.holds, witness.family,
      properties::invariant_named(witness.invariant)->statement, properties::in_words(witness.verdict));
  if (!out_directory.empty()) {
    const auto file = witness_path(out_directory, result.subject, witness);
    message += '\n' + replay_command(file, result.subject, run.report.options.yardstick);
  }
  const bool is_known = run.baseline && compare::is_known(*run.baseline, result.subject.name, witness.invariant);
  return command(is_known ? "notice" : "error",
                 fmt::format("{} violates {}{}", result.subject.name, witness.invariant,
                             is_known ? ", known from the baseline" : ""),
                 message);
}

}  // namespace

std::string github_annotations(const GateRun& run, const std::string& out_directory) {
  std::string text;
  for (std::size_t s = 0; s < run.report.results.size(); ++s) {
    const SubjectResult& result = run.report.results[s];
    if (!run.counts[s]) {
      continue;
    }
    if (s < run.diagnoses.size() && !run.diagnoses[s].telling.empty()) {
      const properties::diagnosis::Diagnosis& diagnosis = run.diagnoses[s];
      text += command("notice", "what is wrong with " + result.subject.name,
                      diagnosis.what + '\n' + diagnosis.where + "\nLook at: " + diagnosis.look_at);
    }
    for (const Witness* witness : witnesses_by_telling(run, s)) {
      text += violation(run, result, *witness, out_directory);
    }
    const std::string& why = result.error.empty() ? result.not_judged : result.error;
    if (!why.empty()) {
      text += command("error", fmt::format("{} could not be judged", result.subject.name), why);
    }
  }
  const Overall overall = overall_of(run);
  return text + command("notice", "carom: " + in_words(overall),
                        fmt::format("{} of {} subjects that count are sound; {}, seed {}{}", overall.sound,
                                    overall.subjects, extent_of(run.report.options), run.report.options.seed,
                                    overall.interrupted ? "; interrupted" : "") +
                            (run.baseline ? "; against the baseline " + compare::baseline_verdict(*run.baseline) : ""));
}

}  // namespace carom::tool
