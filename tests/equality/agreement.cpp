// SPDX-License-Identifier: BSL-1.0
#include "agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <carom/properties/gate/answers.hpp>

namespace carom::equality {
namespace {

using properties::Claim;
using properties::JudgedCase;
using properties::Judgement;
using properties::Status;
using properties::Verdict;

std::string name_of(Status status) {
  return status == Status::holds ? "holds" : status == Status::violated ? "violated" : "skipped";
}

struct Answers {
  Answer first;
  std::vector<Answer> related;
};

Answers answers_of(const JudgedCase& judged_case, const Claim& claim, Session& session,
                   properties::RelationTurn relations) {
  Answers answers{properties::answers_of(session, std::span(&judged_case.generated().collision, 1)).front(), {}};
  const properties::Trial trial(judged_case, claim, properties::lift(answers.first), relations);
  if (trial.question_count() > 0) {
    answers.related = properties::answers_of(session, trial.questions());
  }
  return answers;
}

/// Whether the errors agree to a thousandth of themselves or of the permitted errors. Reports count digits by them.
bool are_alike(const oracles::Accuracy& fast, const oracles::Accuracy& exact, double allowance) {
  return std::ranges::all_of(all_outcome_vectors, [&](OutcomeVector k) {
    return fast.error[k] == exact.error[k] ||
           std::abs(fast.error[k] - exact.error[k]) <= 0x1p-9 * (exact.error[k] + allowance * fast.sensitivity[k]);
  });
}

void compare(const Judgement& fast, const Judgement& exact, const oracles::Yardstick& yardstick,
             const std::string& origin, Agreement& agreement) {
  const auto differs = [&](const std::string& what) { agreement.differences += origin + ": " + what + '\n'; };
  if (fast.verdicts.size() != exact.verdicts.size()) {
    differs("another number of verdicts");
    return;
  }
  for (std::size_t i = 0; i < exact.verdicts.size(); ++i) {
    const Verdict& of_fast = fast.verdicts[i].verdict;
    const Verdict& of_exact = exact.verdicts[i].verdict;
    const std::string name(exact.verdicts[i].invariant->name);
    Outcomes& outcomes = agreement.invariants[name];
    outcomes.holds += of_exact.status == Status::holds ? 1 : 0;
    outcomes.violated += of_exact.status == Status::violated ? 1 : 0;
    if (of_fast.status != of_exact.status || of_fast.is_undecided != of_exact.is_undecided) {
      differs(name + ' ' + name_of(of_fast.status) + ", exactly " + name_of(of_exact.status) + ": " + of_exact.detail);
    }
  }
  // If digits are asked for, the permitted error contains noise, too.
  if (exact.accuracy && !yardstick.digits() &&
      !are_alike(fast.accuracy.value(), *exact.accuracy, yardstick.allowance())) {
    differs("other errors");
  }
}

}  // namespace

void compare_judges(const properties::Case& one, std::span<Examined> subjects, properties::RelationTurn relations,
                    const std::string& origin, Agreement& agreement) {
  ++agreement.cases;
  properties::Stream choices = properties::stream_from(agreement.cases);
  const JudgedCase judged_case(one);
  const JudgedCase judged_exactly(one);  // computes the facts of the case by itself
  for (Examined& examined : subjects) {
    oracles::Limits limits;
    if (choices.chance(3)) {
      limits.digits = choices.integer(1, 18);
    }
    const Claim claim = properties::claim_of(examined.subject, limits);
    const Answers answers = answers_of(judged_case, claim, examined.session, relations);
    // The judge need not compute a backward error that is at most `known`. So if `known` is infinite, lower bounds of
    // the sensitivity decide more often.
    const double known = choices.chance(2) ? 0 : std::numeric_limits<double>::infinity();
    const auto judgement = [&](bool filtered, double known_backward_error) {
      Claim of_judge = claim;
      of_judge.yardstick = claim.yardstick.with_filters(filtered);
      const properties::Trial trial(filtered ? judged_case : judged_exactly, of_judge, properties::lift(answers.first),
                                    relations);
      return trial.judge(answers.related, known_backward_error);
    };
    compare(judgement(true, known), judgement(false, 0), claim.yardstick, origin + ", " + examined.subject.name,
            agreement);
  }
}

}  // namespace carom::equality
