// SPDX-License-Identifier: BSL-1.0
#include "io/replay_subjects.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include <carom/collision/json/text.hpp>
#include <carom/subjects/protocol/spelling.hpp>

#include "io/subject_argument.hpp"

namespace carom::tool {
namespace {

using subjects::protocol::spelling_count;

/// Runs the task. An exception becomes a UsageError that names the subject, unless it is a fault of the judge.
template <class Task>
auto in_its_name(const Subject& subject, const Task& task) {
  try {
    return task();
  } catch (const oracles::JudgeError&) {
    throw;
  } catch (const std::exception& error) {
    throw UsageError(fmt::format("{}: {}", subject.name, error.what()));
  }
}

/// Limits the restarts of a failing program. Each failure is a finding, and a program that hangs takes the full
/// timeout.
constexpr unsigned most_failures = 100;

bool names_subject(const ReadCollision& read) { return read.witness && !read.witness->subject.empty(); }

/// The verdicts of the claimed invariants that compare all answers with the first answer.
std::vector<properties::NamedVerdict> session_verdicts(const properties::Claim& claim, properties::Sameness sameness,
                                                       const std::vector<ReplayedCase>& cases) {
  std::vector<properties::NamedVerdict> verdicts;
  for (const properties::Invariant* invariant : claim.invariants) {
    if (const auto* about = std::get_if<properties::AboutSession>(&invariant->about)) {
      properties::NamedVerdict& named = verdicts.emplace_back(properties::NamedVerdict{invariant, {}});
      for (const ReplayedCase& other : cases) {
        if (named.verdict.status == properties::Status::holds) {
          named.verdict = about->check(cases.front().answer, other.answer, sameness);
        }
      }
    }
  }
  return verdicts;
}

}  // namespace

ReplaySubject::ReplaySubject(const std::string& name, double timeout_seconds, const oracles::Limits& limits,
                             const properties::Domain& within, const std::stop_token& stop) {
  const unsigned spellings = runs_in_this_process(name) ? 1 : spelling_count;
  for (unsigned spelling = 0; spelling < spellings; ++spelling) {
    Subject subject = subject_from_argument(name, timeout_seconds, stop, spelling);
    if (!subject.absent.empty()) {
      throw UsageError(fmt::format("{} is absent: {}", name, subject.absent));
    }
    sessions_.push_back(in_its_name(
        subject, [&] { return properties::open_restarting(subject, restarts_->emplace_back(most_failures), stop); }));
    subject_ = std::move(subject);
  }
  claim_ = properties::claim_of(subject_, limits);
  claim_.within = within;
}

ReplayedCase ReplaySubject::judge(const properties::Case& one) {
  std::vector<ReplayedCase> cases;
  for (Session& session : sessions_) {
    auto [answer, judgement] =
        in_its_name(subject_, [&] { return properties::judge_in_session(claim_, session, one); });
    cases.push_back({std::move(answer), std::move(judgement)});
  }
  const auto shows = [](const ReplayedCase& replayed) { return report::is_violated(replayed.judgement); };
  const auto found = std::find_if(cases.begin(), cases.end(), shows);
  const auto chosen = static_cast<std::size_t>((found == cases.end() ? cases.begin() : found) - cases.begin());
  ReplayedCase result = cases[chosen];
  if (cases.size() > 1) {
    const std::vector<properties::NamedVerdict> verdicts =
        session_verdicts(claim_, properties::sameness_of_answers(subject_), cases);
    result.judgement.verdicts.insert(result.judgement.verdicts.end(), verdicts.begin(), verdicts.end());
  }
  if (subject_.spellings > 1) {
    result.spellings = cases.size();
    result.violated_spellings = static_cast<std::size_t>(std::count_if(cases.begin(), cases.end(), shows));
    result.spelt = subjects::protocol::spelt(one.collision, static_cast<unsigned>(chosen));
  }
  return result;
}

void ReplaySubject::close() {
  for (Session& session : sessions_) {
    in_its_name(subject_, [&session] { session.close(); });
  }
}

ReplaySubjects::ReplaySubjects(std::string subject, double timeout_seconds, const oracles::Limits& limits,
                               properties::Domain within, std::stop_token stop)
    : subject_(std::move(subject)),
      timeout_seconds_(timeout_seconds),
      stop_(std::move(stop)),
      limits_(limits),
      within_(within) {}

ReplaySubject* ReplaySubjects::subject_for(const ReadCollision& read) {
  if (!subject_.empty()) {
    return &named(subject_);
  }
  const bool may_be_judged = names_subject(read) && runs_in_this_process(read.witness->subject);
  return may_be_judged ? &named(read.witness->subject) : nullptr;
}

std::string ReplaySubjects::why_none(const ReadCollision& read) const {
  if (!subject_.empty() || !names_subject(read) || runs_in_this_process(read.witness->subject)) {
    return {};
  }
  return fmt::format("not judged: the subject of the witness is a program; to run it, use --subject {}",
                     carom::printable_line(carom::quoted(read.witness->subject), 4000));
}

void ReplaySubjects::close() {
  for (auto& [name, open] : open_) {
    open.close();
  }
}

ReplaySubject& ReplaySubjects::named(const std::string& name) {
  const auto found = open_.find(name);
  return found != open_.end()
             ? found->second
             : open_.emplace(name, ReplaySubject(name, timeout_seconds_, limits_, within_, stop_)).first->second;
}

}  // namespace carom::tool
