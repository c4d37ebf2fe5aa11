// SPDX-License-Identifier: BSL-1.0
#include <string_view>

#include <fmt/format.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/without_outcome.hpp>

namespace carom::properties::diagnosis {
namespace {

constexpr std::string_view mark = "standard error: ";

bool printed(const Failed& failed) { return failed.said.find(mark) != std::string::npos; }

std::string last_words(const Failed& failed) {
  if (!printed(failed)) {
    return {};
  }
  const std::size_t begin = failed.said.find(mark);
  const std::size_t end = failed.said.find_last_not_of(" \n");
  const std::size_t line = failed.said.find_last_of('\n', end);
  const std::size_t from = line == std::string::npos || line < begin ? begin + mark.size() : line + 1;
  return ": " + failed.said.substr(from, end + 1 - from);
}

std::string counted(std::size_t part, std::size_t whole) { return fmt::format("{} of {}", part, whole); }

}  // namespace

std::vector<FaultOfKind> faults_without_outcome(std::span<const ViolatedCase> examples) {
  std::size_t failed = 0;
  std::size_t refused = 0;
  std::size_t not_finite = 0;
  bool has_printed = false;
  std::string how;
  std::string why;
  for (const ViolatedCase& one : examples) {
    if (const auto* failure = std::get_if<Failed>(&one.answer)) {
      ++failed;
      has_printed = has_printed || printed(*failure);
      how = how.empty() ? failure->why + last_words(*failure) : how;
    } else if (const auto* refusal = std::get_if<Refused>(&one.answer)) {
      ++refused;
      why = why.empty() ? refusal->why : why;
    } else if (const auto* outcome = std::get_if<ReportedOutcome>(&one.answer)) {
      not_finite += oracles::is_finite(*outcome) || !validate(one.one.collision).empty() ? 0 : 1;
    }
  }
  std::vector<FaultOfKind> faults;
  if (failed > 0) {
    faults.push_back({AnswerKind::failed,
                      {fmt::format("It fails to answer in {} examined violated cases: it {}.",
                                   counted(failed, examples.size()), how),
                       has_printed ? "its standard error output, below the witness"
                                   : "its answer to the collision of the witness"}});
  }
  if (not_finite > 0) {
    faults.push_back({AnswerKind::not_finite,
                      {fmt::format("Its answer contains infinities or NaN in {} examined violated cases.",
                                   counted(not_finite, examples.size())),
                       "divisions by zero, square roots of negative numbers, overflow of squares"}});
  }
  if (refused > 0) {
    faults.push_back({AnswerKind::refused,
                      {fmt::format("It refuses valid collisions in {} examined violated cases: {}",
                                   counted(refused, examples.size()), why),
                       "the check of the input, or an error that the solver throws by mistake"}});
  }
  return faults;
}

}  // namespace carom::properties::diagnosis
