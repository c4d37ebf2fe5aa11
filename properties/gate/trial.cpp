// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/laws/judge_error.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {
namespace {

/// Empty if one collision is not valid.
std::vector<oracles::ExactCase> exact_cases(const std::vector<Collision>& collisions, bool filtered) {
  std::vector<oracles::ExactCase> cases;
  cases.reserve(collisions.size());
  for (const Collision& collision : collisions) {
    if (!validate(collision).empty()) {
      return {};
    }
    cases.emplace_back(collision, filtered);
  }
  return cases;
}

/// The stored result for this yardstick. If there is none, stores `work_out()`.
template <class T, class WorkOut>
T remembered(std::vector<std::pair<std::pair<double, double>, T>>& known, const oracles::Yardstick& yardstick,
             const WorkOut& work_out) {
  const std::pair key{yardstick.unit_roundoff(), yardstick.allowance()};
  const auto found = std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.first == key; });
  return found != known.end() ? found->second : known.emplace_back(key, work_out()).second;
}

bool are_judged(std::span<const oracles::ExactCase> questions, const oracles::Yardstick& yardstick) {
  return std::all_of(questions.begin(), questions.end(),
                     [&](const oracles::ExactCase& question) { return !reason_unjudged(question, yardstick); });
}

/// Whether the declared effects do not change the related collisions.
bool are_free_of_effects(const Claim& claim, std::span<const oracles::ExactCase> questions) {
  const auto is_free = [&](const oracles::ExactCase& question) {
    const Collision judged = judged_collision(question.collision(), claim.effects);
    return !is_any(changes_between(question.collision(), judged)) &&
           !is_any(at_declared_limit(question, claim.effects, claim.yardstick.rounding()));
  };
  return !depend_on_approach(claim.effects) || std::all_of(questions.begin(), questions.end(), is_free);
}

bool are_within(const Domain& domain, std::span<const oracles::ExactCase> questions) {
  return domain.is_everything() ||
         std::all_of(questions.begin(), questions.end(),
                     [&](const oracles::ExactCase& question) { return contains(domain, question.collision()); });
}

std::vector<Deviation> deviations_of(const Subject& subject) {
  std::vector<Deviation> deviations;
  for (const std::string& text : subject.deviates) {
    try {
      deviations.push_back(deviation_from(text));
    } catch (const std::invalid_argument&) {
      continue;
    }
  }
  return deviations;
}

}  // namespace

bool Claim::is_made_in(const Invariant& invariant, const Family& family) const {
  return std::none_of(deviations.begin(), deviations.end(), [&](const Deviation& deviation) {
    return deviation.invariant == &invariant && deviation.family == &family;
  });
}

std::vector<const Invariant*> not_claimed_without_matrix(const Subject& subject) {
  std::vector<const Invariant*> not_claimed;
  for (const Invariant& invariant : all_invariants()) {
    if (!subject.shows_collision_matrix && invariant.is_of_matrix() && invariant.claimed_for(subject.law)) {
      not_claimed.push_back(&invariant);
    }
  }
  return not_claimed;
}

Claim claim_of(const Subject& subject, const oracles::Limits& limits) {
  Claim claim{subject.law,    oracles::Yardstick::of(subject.precision, limits), {}, deviations_of(subject), {},
              subject.effects};
  for (const Invariant& invariant : all_invariants()) {
    const bool deviates = std::any_of(
        claim.deviations.begin(), claim.deviations.end(),
        [&](const Deviation& deviation) { return deviation.invariant == &invariant && deviation.family == nullptr; });
    const bool shows_what_it_is_of = subject.shows_collision_matrix || !invariant.is_of_matrix();
    if (invariant.claimed_for(subject.law) && shows_what_it_is_of && !deviates) {
      claim.invariants.push_back(&invariant);
    }
  }
  return claim;
}

oracles::Limits limits_with(double limit_ulps, std::optional<int> digits) {
  constexpr int most_digits = 18;
  if (!(limit_ulps > 0) || !std::isfinite(limit_ulps)) {
    throw std::invalid_argument("limit_ulps: expected a positive number, found " + std::to_string(limit_ulps));
  }
  if (digits && (*digits < 1 || *digits > most_digits)) {
    throw std::invalid_argument("digits: expected an integer from 1 to " + std::to_string(most_digits) + ", found " +
                                std::to_string(*digits));
  }
  return {limit_ulps, digits};
}

JudgedCase::JudgedCase(const Case& generated, bool filtered, const DeclaredEffects& effects)
    : generated_(generated), filtered_(filtered), effects_(effects) {
  if (validate(generated.collision).empty()) {
    exact_.emplace(judged_collision(generated.collision, effects), filtered);
  }
}

const JudgedCase::Questions& JudgedCase::questions_and_results_of(const Invariant& invariant,
                                                                  const Kinds& kinds) const {
  CAROM_EXPECTS(is_valid(), invariant.name);
  return questions_.get(&invariant, [&] {
    const auto& relation = std::get<AboutRelation>(invariant.about);
    const auto ask = std::get<AboutRelation::OfCollision>(relation.ask);
    return Questions{exact_cases(ask(exact().collision(), kinds), filtered_), {}};
  });
}

std::span<const oracles::ExactCase> JudgedCase::questions_of(const Invariant& invariant, const Kinds& kinds) const {
  return questions_and_results_of(invariant, kinds).cases;
}

EffectFlags JudgedCase::at_limit(const oracles::Yardstick& yardstick) const {
  return at_declared_limit(oracles::ExactCase(generated_.collision, filtered_), effects_, yardstick.rounding());
}

bool JudgedCase::collides() const {
  return exact().state() == oracles::ContactState::colliding ||
         changes_between(generated_.collision, exact().collision())[DeclaredEffect::slop];
}

EffectFlags JudgedCase::decided_by_approach(const oracles::Yardstick& yardstick) const {
  if (!depend_on_approach(effects_) || !collides()) {
    return {};
  }
  return reason_unjudged_by(yardstick) == Unjudged::at_declared_limit
             ? at_limit(yardstick)
             : changes_between(generated_.collision, exact().collision());
}

std::optional<Unjudged> JudgedCase::reason_unjudged_by(const oracles::Yardstick& yardstick) const {
  return remembered(unjudged_, yardstick, [&]() -> std::optional<Unjudged> {
    if (depend_on_approach(effects_) && is_any(at_limit(yardstick))) {
      return Unjudged::at_declared_limit;
    }
    return reason_unjudged(exact(), yardstick);
  });
}

bool JudgedCase::are_questions_judged_by(const oracles::Yardstick& yardstick, const Invariant& invariant,
                                         const Kinds& kinds) const {
  const Questions& questions = questions_and_results_of(invariant, kinds);
  return remembered(questions.are_judged, yardstick, [&] { return are_judged(questions.cases, yardstick); });
}

Trial::Trial(const JudgedCase& judged_case, const Claim& claim, ExactAnswer answer, RelationTurn relations)
    : judged_case_(&judged_case),
      claim_(&claim),
      answer_(std::move(answer)),
      relations_(relations),
      questions_(claim.invariants.size()) {
  CAROM_EXPECTS(judged_case.effects() == claim.effects);
  if (std::holds_alternative<oracles::LiftedOutcome>(answer_) && judged_case.is_valid()) {
    oracles::on_collision(judged_case.generated().collision, [this] { prepare(); });
  }
}

void Trial::prepare() {
  const JudgedCase& judged_case = *judged_case_;
  const Claim& claim = *claim_;
  limited_ = take_out_effects(answer_, claim.effects, judged_case.exact(), claim.law, claim.yardstick.allowance());
  if (relations_.every > 0 && claim.law == Law::coulomb &&
      !oracles::has_one_coulomb_answer(judged_case.exact(), claim.yardstick.allowance())) {
    return;
  }
  const auto* outcome = std::get_if<oracles::LiftedOutcome>(&answer_);
  for (std::size_t i = 0; i < claim.invariants.size(); ++i) {
    const Invariant& invariant = *claim.invariants[i];
    const auto* relation = std::get_if<AboutRelation>(&invariant.about);
    if (relation == nullptr || !relations_.has(i)) {
      continue;
    }
    if (const auto* of_outcome = std::get_if<AboutRelation::OfOutcome>(&relation->ask)) {
      by_outcome_.push_back(
          exact_cases((*of_outcome)(judged_case.exact().collision(), outcome->rounded(), claim.within.kinds),
                      claim.yardstick.filtered()));
      questions_[i] = by_outcome_.back();
    } else {
      questions_[i] = judged_case.questions_of(invariant, claim.within.kinds);
    }
    if (!are_within(claim.within, questions_[i]) || !are_free_of_effects(claim, questions_[i])) {
      questions_[i] = {};
    }
  }
}

std::vector<Collision> Trial::questions() const {
  std::vector<Collision> all;
  all.reserve(question_count());
  add_questions(all);
  return all;
}

void Trial::add_questions(std::vector<Collision>& all) const {
  for (const auto& of_invariant : questions_) {
    for (const oracles::ExactCase& question : of_invariant) {
      all.push_back(question.collision());
    }
  }
}

std::size_t Trial::question_count() const {
  std::size_t count = 0;
  for (const auto& of_invariant : questions_) {
    count += of_invariant.size();
  }
  return count;
}

std::size_t Trial::most_questions() const {
  std::size_t most = 0;
  for (const auto& of_invariant : questions_) {
    most = std::max(most, of_invariant.size());
  }
  return most;
}

EffectFlags Trial::decided_by() const {
  if (claim_->effects == DeclaredEffects{} || !judged_case_->collides()) {
    return {};
  }
  EffectFlags flags = judged_case_->decided_by_approach(claim_->yardstick);
  for (const DeclaredEffect limit : {DeclaredEffect::max_speed, DeclaredEffect::max_angular_velocity}) {
    flags[limit] = limited_[limit];
  }
  return flags;
}

void Trial::require_one_answer_each(std::size_t count) const {
  if (count != question_count()) {
    throw std::invalid_argument("a trial needs one answer to each of its questions");
  }
}

Judgement Trial::judge(std::span<const Answer> answers, double known_backward_error) const {
  require_one_answer_each(answers.size());
  std::vector<ExactAnswer> lifted;
  lifted.reserve(most_questions());
  return judge_by(
      [&](std::span<const oracles::ExactCase> questions) {
        lifted.clear();
        for (const Answer& answer : answers.first(questions.size())) {
          lift_without_matrix(answer, lifted.emplace_back(NotFinite{}));
        }
        answers = answers.subspan(questions.size());
        return std::span<ExactAnswer>(lifted);
      },
      known_backward_error);
}

Judgement Trial::judge(std::span<ExactAnswer> answers, double known_backward_error) const {
  require_one_answer_each(answers.size());
  return judge_by(
      [&](std::span<const oracles::ExactCase> questions) {
        const std::span<ExactAnswer> to_these = answers.first(questions.size());
        answers = answers.subspan(questions.size());
        return to_these;
      },
      known_backward_error);
}

/// `answers_to(questions)` returns the lifted answers to the next questions. The answers are valid until the next call.
template <class AnswersTo>
Judgement Trial::judge_by(const AnswersTo& answers_to, double known_backward_error) const {
  return oracles::on_collision(judged_case_->generated().collision, [&] {
    Judgement judgement;
    if (const auto* skipped = std::get_if<Skipped>(&answer_)) {
      judgement.skipped = *skipped;
      return judgement;
    }
    if (judged_case_->is_valid()) {
      judgement.unjudged = judged_case_->reason_unjudged_by(claim_->yardstick);
      judgement.decided_by = decided_by();
    }
    if (!judgement.unjudged) {
      add_verdicts(judgement, answers_to, known_backward_error);
    }
    return judgement;
  });
}

template <class AnswersTo>
void Trial::add_verdicts(Judgement& judgement, const AnswersTo& answers_to, double known_backward_error) const {
  const auto* outcome = std::get_if<oracles::LiftedOutcome>(&answer_);
  std::optional<Evidence> evidence;
  if (outcome != nullptr && judged_case_->is_valid()) {
    if (determines_outcome(claim_->law)) {
      judgement.accuracy =
          oracles::accuracy(judged_case_->exact(), claim_->law, *outcome, claim_->yardstick, known_backward_error);
    }
    evidence.emplace(Evidence{judged_case_->exact(), judged_case_->generated().convex_uniform, claim_->law,
                              claim_->yardstick, *outcome, judgement.accuracy ? &*judgement.accuracy : nullptr,
                              claim_->within.kinds});
  }
  judgement.verdicts.reserve(claim_->invariants.size());
  for (std::size_t i = 0; i < claim_->invariants.size(); ++i) {
    const Invariant& invariant = *claim_->invariants[i];
    std::optional<Verdict> verdict;
    if (const auto* of_answer = std::get_if<AboutAnswer>(&invariant.about)) {
      if (of_answer->to_valid == judged_case_->is_valid()) {
        verdict = of_answer->check(judged_case_->generated().collision, answer_, claim_->law);
      }
    } else if (evidence && !invariant.asks()) {
      verdict = verdict_on_outcome(invariant, *evidence);
    } else if (evidence && relations_.has(i)) {
      verdict = verdict_on_relation(invariant, questions_[i], *evidence, answers_to);
    }
    if (verdict) {
      judgement.verdicts.push_back({&invariant, *std::move(verdict)});
    }
  }
}

std::optional<Verdict> Trial::verdict_on_outcome(const Invariant& invariant, const Evidence& evidence) const {
  const auto* of_outcome = std::get_if<AboutOutcome>(&invariant.about);
  const auto* of_matrix = std::get_if<AboutMatrix>(&invariant.about);
  if (of_outcome == nullptr && of_matrix == nullptr) {
    return std::nullopt;
  }
  if (is_any(limited_) && (of_outcome == nullptr || !of_outcome->judges_limited)) {
    return does_not_apply("a declared limit shortens a velocity; `backward_error` judges the outcome");
  }
  return of_outcome != nullptr ? of_outcome->check(evidence) : of_matrix->check(evidence);
}

template <class AnswersTo>
Verdict Trial::verdict_on_relation(const Invariant& invariant, std::span<const oracles::ExactCase> questions,
                                   const Evidence& evidence, const AnswersTo& answers_to) const {
  if (questions.empty()) {
    return does_not_apply(claim_->law == Law::coulomb
                              ? "the law may have several answers, or the related collision is out of range"
                              : "the related collision is out of range");
  }
  const std::span<ExactAnswer> answers = answers_to(questions);
  const auto& relation = std::get<AboutRelation>(invariant.about);
  const bool is_judged = std::holds_alternative<AboutRelation::OfCollision>(relation.ask)
                             ? judged_case_->are_questions_judged_by(claim_->yardstick, invariant, claim_->within.kinds)
                             : are_judged(questions, claim_->yardstick);
  if (!is_judged) {
    return does_not_apply("the gate does not judge the related collision");
  }
  std::vector<Related> related;
  related.reserve(questions.size());
  for (std::size_t i = 0; i < questions.size(); ++i) {
    take_out_effects(answers[i], claim_->effects, questions[i], claim_->law, claim_->yardstick.allowance());
    related.push_back({questions[i], answers[i]});
  }
  return relation.check(evidence, related);
}

Judgement judge_answer(const JudgedCase& judged_case, const Claim& claim, ExactAnswer answer,
                       double known_backward_error) {
  return Trial(judged_case, claim, std::move(answer), no_relations)
      .judge(std::span<ExactAnswer>(), known_backward_error);
}

Judgement try_case(const JudgedCase& judged_case, const Claim& claim, const ExactSolve& solve) {
  const Trial trial(judged_case, claim, solve(judged_case.generated().collision));
  std::vector<ExactAnswer> answers;
  for (const Collision& question : trial.questions()) {
    answers.push_back(solve(question));
  }
  return trial.judge(answers);
}

}  // namespace carom::properties
