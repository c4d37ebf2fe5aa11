// SPDX-License-Identifier: GPL-3.0-or-later
#include "agreement.hpp"

#include <cmath>

#include <carom/properties/answers.hpp>

namespace carom::equality {
namespace {

using properties::Claim;
using properties::ExactAnswer;
using properties::JudgedCase;
using properties::Judgement;
using properties::Status;

std::string_view name_of(Status status) {
  switch (status) {
    case Status::holds:
      return "holds";
    case Status::violated:
      return "violated";
    case Status::skipped:
      break;
  }
  return "skipped";
}

/// The answers of a subject to a case, and to the questions that its outcome raises.
struct Answers {
  Answer first;
  std::vector<Answer> related;
};

Judgement judged(const properties::Case& one, const Subject& subject, const Claim& claim, Relations relations,
                 const Answers& answers, std::chrono::nanoseconds& spent) {
  const auto start = std::chrono::steady_clock::now();
  const JudgedCase judged_case(one);
  const properties::Trial trial(judged_case, claim, properties::lift(answers.first),
                                properties::shown_collision_matrix(subject, judged_case),
                                relations == Relations::judged);
  Judgement judgement = trial.judge(properties::lifted(answers.related));
  spent += std::chrono::steady_clock::now() - start;
  return judgement;
}

Answers answers_of(const properties::Case& one, const Claim& claim, Session& session, Relations relations) {
  Answers answers{properties::answers_of(session, std::span(&one.collision, 1)).front(), {}};
  const JudgedCase judged_case(one);
  const properties::Trial trial(judged_case, claim, properties::lift(answers.first), std::nullopt,
                                relations == Relations::judged);
  if (trial.question_count() > 0) {
    answers.related = properties::answers_of(session, trial.questions());
  }
  return answers;
}

}  // namespace

Agreement& Agreement::operator+=(const Agreement& other) {
  judgements += other.judgements;
  verdicts += other.verdicts;
  for (const auto& [name, counts] : other.invariants) {
    Outcomes& into = invariants[name];
    into.holds += counts.holds;
    into.violated += counts.violated;
    into.skipped += counts.skipped;
  }
  differences.insert(differences.end(), other.differences.begin(), other.differences.end());
  filtered += other.filtered;
  rational += other.rational;
  return *this;
}

void compare_judges(const properties::Case& one, const Subject& subject, Session& session, Relations relations,
                    const std::string& origin, Agreement& agreement) {
  const Claim claim = properties::claim_of(subject, {});
  Claim by_rationals = claim;
  by_rationals.yardstick.filtered = false;
  const Answers answers = answers_of(one, claim, session, relations);
  const Judgement fast = judged(one, subject, claim, relations, answers, agreement.filtered);
  const Judgement exact = judged(one, subject, by_rationals, relations, answers, agreement.rational);
  ++agreement.judgements;
  const auto differs = [&](const std::string& what) {
    agreement.differences.push_back(origin + ", " + subject.name + ": " + what);
  };
  if (fast.verdicts.size() != exact.verdicts.size()) {
    differs("another number of verdicts");
    return;
  }
  for (std::size_t i = 0; i < exact.verdicts.size(); ++i) {
    const Status status = exact.verdicts[i].verdict.status;
    const std::string name(exact.verdicts[i].invariant->name);
    ++agreement.verdicts;
    Outcomes& outcomes = agreement.invariants[name];
    ++(status == Status::holds ? outcomes.holds : status == Status::violated ? outcomes.violated : outcomes.skipped);
    if (fast.verdicts[i].verdict.status != status) {
      differs(name + ' ' + std::string(name_of(fast.verdicts[i].verdict.status)) + ", exactly " +
              std::string(name_of(status)) + ": " + exact.verdicts[i].verdict.detail);
    }
  }
}

}  // namespace carom::equality
