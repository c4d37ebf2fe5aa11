// SPDX-License-Identifier: BSL-1.0
#include <string_view>

#include <fmt/format.h>

#include <carom/collision/json/text.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using properties::Witness;

constexpr std::size_t longest_title = 200;
constexpr std::size_t longest_message = 4000;

/// Escapes %, line ends and the letters in `ends` as % and two digits. Unescaped, they would end a command or one of
/// its fields.
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
  using carom::printable;
  return fmt::format("::{} title={}::{}\n", name, escaped(printable_line(title, longest_title), ":,"),
                     escaped(printable(message, longest_message), ""));
}

std::string violation(const Run& run, const properties::SubjectResult& result, const Witness& witness,
                      const std::string& out_directory) {
  const std::string& name = result.subject.name;
  const properties::Invariant& invariant = *witness.invariant;
  std::string message = fmt::format("{}, most often in {}. {}\n{}", violated_of_judged_cases(result.count(invariant)),
                                    witness.family->name, invariant.statement, properties::in_words(witness.verdict));
  if (!out_directory.empty()) {
    message += '\n' + replay_line(run, result.subject, witness, out_directory);
  }
  const bool known = run.baseline && is_known(*run.baseline, name, invariant);
  return command(known ? "notice" : "error",
                 fmt::format("{} violates {}{}", name, invariant.name, known ? " (known from the baseline)" : ""),
                 message);
}

}  // namespace

std::string github_annotations(const Run& run, const std::string& out_directory) {
  std::string text;
  if (run.judge_error) {
    text += command("error", "the judge failed", properties::in_words(*run.judge_error));
  }
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    if (!run.counts[s]) {
      continue;
    }
    const properties::SubjectResult& result = run.results[s];
    const std::string& name = result.subject.name;
    for (const properties::diagnosis::Fault& fault : run.diagnoses[s].faults) {
      text += command("notice", "diagnosis of " + name,
                      fmt::format("{}", fmt::join(properties::diagnosis::lines_of(fault), "\n")));
    }
    for (const Witness* witness : witnesses_by_telling(run, s)) {
      text += violation(run, result, *witness, out_directory);
    }
    if (!why_not_judged(result).empty()) {
      text += command("error", fmt::format("{} could not be judged", name), why_not_judged(result));
    }
  }
  const Overall overall = overall_of(run);
  return text +
         command("notice", "carom: " + in_words(overall),
                 fmt::format("{} of {} subjects that count are sound; {}, seed {}{}", overall.sound, overall.subjects,
                             extent_of(run), run.options.seed, overall.interrupted ? "; interrupted" : "") +
                     (run.baseline ? "; against the baseline " + baseline_verdict(*run.baseline) : ""));
}

}  // namespace carom::report
