// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <chrono>

#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/gate/shrink.hpp>
#include <carom/properties/gate/witness.hpp>

namespace carom::properties {
namespace {

constexpr std::size_t most_shrink_calls = 4000;

/// The limit of the time of all failures of a subject together, because each hang costs a timeout.
constexpr std::chrono::seconds longest_failing{5};

/// The only verdict; `holds` if there is none on this case.
Verdict single_verdict(const Judgement& judgement) {
  return judgement.verdicts.empty() ? Verdict{} : judgement.verdicts.front().verdict;
}

std::size_t family_of_witness(const SubjectResult& result, const Invariant& invariant) {
  std::size_t best = 0;
  std::uint64_t most = 0;
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    const auto found = result.families[f].counts.find(&invariant);
    const std::uint64_t violated = found == result.families[f].counts.end() ? 0 : found->second.violated;
    if (violated > most) {
      most = violated;
      best = f;
    }
  }
  return best;
}

}  // namespace

Witness found_witness(const SubjectResult& result, const GateOptions& options, const Invariant& invariant) {
  const std::size_t family = family_of_witness(result, invariant);
  const WorstViolation& worst = result.families[family].worst.at(&invariant);
  return {&invariant,     options.families[family],
          worst.index,    worst.original,
          worst.original, worst.verdict,
          worst.answer,   worst.verdict,
          worst.answer};
}

Witness shrunk_witness(const Subject& subject, const Claim& claim, Witness witness, const Domain& within) {
  Claim only = claim;
  only.invariants = {witness.invariant};
  Restarts restarts(most_shrink_calls, longest_failing);
  Session session = open_restarting(subject, restarts);
  bool is_over = false;
  const auto verdict_on = [&](const Case& one) {
    if (!contains(within, one.collision)) {
      return Verdict{};
    }
    try {
      return is_over ? Verdict{} : single_verdict(judge_in_session(only, session, one).judgement);
    } catch (const SessionFailure&) {
      is_over = true;  // the results so far stay
      return Verdict{};
    }
  };
  witness.is_reproduced = verdict_on(witness.original).status == Status::violated || is_over;
  const Case simplest = simplest_violation(witness.original, *only.invariants[0], witness.verdict, verdict_on,
                                           most_shrink_calls, within.kinds);
  only.yardstick = claim.yardstick.with_filters(false);  // the report shows numbers from exact arithmetic
  Restarts once(2);
  Session fresh = is_over ? open_restarting(subject, once) : std::move(session);
  const AnswerAndJudgement shrunk = judge_in_session(only, fresh, simplest);
  fresh.close();
  if (single_verdict(shrunk.judgement).status == Status::violated) {
    witness.shrunk = simplest;
    witness.verdict = single_verdict(shrunk.judgement);
    witness.answer = shrunk.answer;
  }
  return witness;
}

void add_witnesses(GateReport& report) {
  const GateOptions& options = report.options;
  struct FoundWitness {
    std::size_t subject;
    std::size_t witness;
  };
  std::vector<FoundWitness> found;
  for (std::size_t s = 0; s < report.results.size(); ++s) {
    SubjectResult& result = report.results[s];
    for (const Invariant* invariant : result.violated_invariants()) {
      found.push_back({s, result.witnesses.size()});
      result.witnesses.push_back(found_witness(result, options, *invariant));
    }
  }
  options.workers.run(found.size(), [&](std::size_t i) {
    SubjectResult& result = report.results[found[i].subject];
    Witness& witness = result.witnesses[found[i].witness];
    const std::string fault = why_failed([&] {
      if (options.shrinks && is_explained(options, found[i].subject) && !options.stop.stop_requested()) {
        Claim claim = claim_of(result.subject, options.limits);
        claim.within = options.within;
        witness = shrunk_witness(result.subject, claim, witness, options.within);
      }
    });
    if (!fault.empty()) {
      witness.not_shrunk = fault;  // it stays as it was found
    }
  });
}

bool is_as_bad(const Verdict& verdict, const Collision& collision, const Verdict& found, const Collision& found_on) {
  // A shrunk violation keeps at least a sixteenth of the original's seriousness, and at least 1 if the original has 1.
  const double worst = seriousness(found, found_on);
  const double kept = worst >= 16 ? worst / 16 : std::min(worst, 1.0);
  // It also keeps a sixteenth of the relative residual. A residual above 2⁻¹⁰ is more than rounding, so a sixteenth of
  // 2⁻¹⁰ suffices.
  constexpr double plain = 0x1p-10;
  const double kept_of_size = std::min(found.relative_residual(), plain) / 16;
  return seriousness(verdict, collision) >= kept && verdict.relative_residual() >= kept_of_size &&
         verdict.kind == found.kind;
}

Case simplest_violation(const Case& one, const Invariant& invariant, const Verdict& found,
                        const std::function<Verdict(const Case&)>& verdict_on, std::size_t most_calls,
                        const Kinds& kinds) {
  // An invalid collision is not worth shrinking. The shapes of a shrunk collision are unknown.
  const auto* const of_matrix = std::get_if<AboutMatrix>(&invariant.about);
  if (!JudgedCase(one).is_valid() || (of_matrix != nullptr && of_matrix->rests_on_shapes)) {
    return one;
  }
  const auto still_fails = [&](const Collision& collision) {
    if (!is_no_further_beyond_domain(collision, one.collision)) {
      return false;
    }
    const Verdict verdict = verdict_on({collision, one.convex_uniform});
    return verdict.status == Status::violated && is_as_bad(verdict, collision, found, one.collision);
  };
  return {shrink(one.collision, still_fails, most_calls, kinds), one.convex_uniform};
}

AnswerAndJudgement judge_in_session(const Claim& claim, Session& session, const Case& one) {
  const JudgedCase judged_case(one, claim.yardstick.filtered(), claim.effects);
  const Answer answer = answers_of(session, std::span(&one.collision, 1)).front();
  const Trial trial(judged_case, claim, lift(answer));
  const std::vector<Answer> replies =
      trial.question_count() == 0 ? std::vector<Answer>{} : answers_of(session, trial.questions());
  return {answer, trial.judge(replies)};
}

AnswerAndJudgement judge_one(const Subject& subject, const Claim& claim, const Case& one) {
  Session session = of_subject(subject.open);
  AnswerAndJudgement judged = judge_in_session(claim, session, one);
  of_subject([&] { session.close(); });
  return judged;
}

}  // namespace carom::properties
