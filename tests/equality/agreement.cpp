// SPDX-License-Identifier: BSL-1.0
#include "agreement.hpp"

#include <limits>

#include <carom/properties/trial/answers.hpp>

namespace carom::equality {
namespace {

properties::RelationTurn turn_of(Relations relations) {
  return relations == Relations::judged ? properties::RelationTurn() : properties::no_relations;
}

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

struct Answers {
  Answer first;
  std::vector<Answer> related;
};

class Judge {
 public:
  Judge(const properties::Case& one, bool filtered) : judged_case_(one), filtered_(filtered) {}

  Judgement operator()(Claim claim, Relations relations, const Answers& answers, double known_backward_error,
                       std::chrono::nanoseconds& spent) const {
    claim.yardstick.filtered = filtered_;
    const auto start = std::chrono::steady_clock::now();
    const properties::Trial trial(judged_case_, claim, properties::lift(answers.first), turn_of(relations));
    Judgement judgement = trial.judge(answers.related, known_backward_error);
    spent += std::chrono::steady_clock::now() - start;
    return judgement;
  }

 private:
  JudgedCase judged_case_;
  bool filtered_;
};

Answers answers_of(const JudgedCase& judged_case, const Claim& claim, Session& session, Relations relations) {
  Answers answers{properties::answers_of(session, std::span(&judged_case.generated().collision, 1)).front(), {}};
  const properties::Trial trial(judged_case, claim, properties::lift(answers.first), turn_of(relations));
  if (trial.question_count() > 0) {
    answers.related = properties::answers_of(session, trial.questions());
  }
  return answers;
}

void compare(const Judgement& fast, const Judgement& exact, const std::string& origin, Agreement& agreement) {
  ++agreement.judgements;
  const auto differs = [&](const std::string& what) { agreement.differences.push_back(origin + ": " + what); };
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

}  // namespace

Agreement& Agreement::operator+=(const Agreement& other) {
  cases += other.cases;
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

void compare_judges(const properties::Case& one, std::span<Examined> subjects, Relations relations,
                    const std::string& origin, Agreement& agreement) {
  ++agreement.cases;
  properties::Stream choices = properties::stream_from(agreement.cases);
  const JudgedCase judged_case(one);
  const Judge fast(one, true);
  const Judge exact(one, false);
  for (Examined& examined : subjects) {
    oracles::Yardstick yardstick;
    if (choices.chance(3)) {
      yardstick.digits = choices.integer(1, 18);
    }
    const Claim claim = properties::claim_of(examined.subject, yardstick);
    const Answers answers = answers_of(judged_case, claim, examined.session, relations);
    // The judge need not compute a backward error that is at most `known`. So if `known` is infinite, lower bounds of
    // the sensitivity decide more often.
    const double known = choices.chance(2) ? 0 : std::numeric_limits<double>::infinity();
    compare(fast(claim, relations, answers, known, agreement.filtered),
            exact(claim, relations, answers, 0, agreement.rational), origin + ", " + examined.subject.name, agreement);
  }
}

}  // namespace carom::equality
