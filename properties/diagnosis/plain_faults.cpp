// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/plain_faults.hpp>
#include <carom/properties/diagnosis/where.hpp>

namespace carom::properties::diagnosis {
namespace {

bool is_binary32(double x) {
  return std::abs(x) <= std::numeric_limits<float>::max() && static_cast<double>(static_cast<float>(x)) == x;
}

/// Whether x has more than 20 significant bits.
bool is_long(double x) {
  int exponent = 0;
  const double scaled = std::ldexp(std::frexp(x, &exponent), 20);
  return scaled != std::trunc(scaled);
}

}  // namespace

void NarrowAnswers::add(const Collision& collision, const Outcome<double>& outcome) {
  const Outcome<double> unchanged_outcome = unchanged(collision);
  const auto before = vectors(unchanged_outcome);
  const auto after = vectors(outcome);
  bool tells = false;
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      const double x = (*after[k])[i];
      const double x_before = (*before[k])[i];
      fit_ = fit_ && (x == x_before || is_binary32(x));
      tells = tells || (x != x_before && is_long(x) && !is_binary32(x_before));
    }
  }
  ++count_;
  telling_ += tells ? 1 : 0;
}

bool NarrowAnswers::are_binary32() const { return fit_ && telling_ >= least_violated; }

Fault NarrowAnswers::fault(Precision claimed) const {
  return {fmt::format("Every velocity in its {} examined answers fits binary32, but it claims {}: it computes or "
                      "stores velocities in single precision.",
                      count_, name_of(claimed)),
          "the claimed precision, and conversions to float"};
}

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
