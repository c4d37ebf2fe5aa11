// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <utility>

#include <carom/collision/validate.hpp>
#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/task.hpp>

namespace carom::properties {
namespace {

constexpr std::uint64_t one_asked_again_of = 10;

/// The approximate number of cases of a run that the gate asks again in a separate session.
constexpr std::uint64_t most_remembered = 64;

/// The answers of a session to a batch. If the session failed, some are missing.
struct Batch {
  std::vector<Answer> answers;
  std::exception_ptr failure;
};

Batch batch_of(Session& session, std::span<const Collision> collisions) {
  try {
    return {answers_of(session, collisions), nullptr};
  } catch (const SessionFailure& failure) {
    return {failure.answered(), std::current_exception()};
  }
}

Collision invalid_collision() {
  Collision invalid;
  invalid.a.mass = std::numeric_limits<double>::quiet_NaN();
  return invalid;
}

/// The verdict of `finite` or `invalid_refused` on a failure to answer. None if the subject answered, or does not claim
/// the invariant.
std::optional<NamedVerdict> verdict_on_failure(const Claim& claim, const Case& one, const Answer& answer) {
  if (!std::holds_alternative<Failed>(answer)) {
    return std::nullopt;
  }
  const bool is_valid = validate(one.collision).empty();
  for (const Invariant* invariant : claim.invariants) {
    const auto* about = std::get_if<AboutAnswer>(&invariant->about);
    if (about != nullptr && about->to_valid == is_valid) {
      return NamedVerdict{invariant, about->check(one.collision, lift(answer), claim.law)};
    }
  }
  return std::nullopt;
}

/// The questions of all trials, in order.
std::vector<Collision> questions_of(const std::vector<Trial>& trials) {
  std::size_t count = 0;
  for (const Trial& trial : trials) {
    count += trial.question_count();
  }
  std::vector<Collision> questions;
  questions.reserve(count);
  for (const Trial& trial : trials) {
    trial.add_questions(questions);
  }
  return questions;
}

/// The cases with the effects that the subject declares. Empty if it declares none.
std::deque<JudgedCase> with_effects(const Claim& claim, const std::deque<JudgedCase>& cases) {
  std::deque<JudgedCase> own;
  for (const JudgedCase& one : cases) {
    if (claim.effects != DeclaredEffects{}) {
      oracles::on_collision(one.generated().collision,
                            [&] { own.emplace_back(one.generated(), claim.yardstick.filtered(), claim.effects); });
    }
  }
  return own;
}

bool cut_after_violation(Judgement& judgement) {
  const auto found = std::find_if(judgement.verdicts.begin(), judgement.verdicts.end(),
                                  [](const NamedVerdict& named) { return named.verdict.status == Status::violated; });
  if (found == judgement.verdicts.end()) {
    return false;
  }
  judgement.verdicts.erase(found + 1, judgement.verdicts.end());
  return true;
}

void drop_unclaimed(Judgement& judgement, const Claim& claim, const Family& family) {
  if (!claim.deviations.empty()) {
    std::erase_if(judgement.verdicts,
                  [&](const NamedVerdict& named) { return !claim.is_made_in(*named.invariant, family); });
  }
}

}  // namespace

void FirstViolation::add_to(SubjectTally& tally, const Claim& claim) const {
  oracles::on_collision(asked.one.collision, [&] {
    if (is_of_new_case) {
      tally.add(asked.family, asked.index, JudgedCase(asked.one, claim.yardstick.filtered(), claim.effects),
                asked.answer, judgement, claim);
    } else {
      tally.add(asked.family, asked.index, asked.one, asked.answer, judgement.verdicts.back());
    }
  });
}

bool is_asked_again(std::uint64_t index) { return index % one_asked_again_of == 0; }

bool is_remembered(std::uint64_t index, std::size_t families) {
  const std::uint64_t of_each_family = std::max<std::uint64_t>(1, most_remembered / families);
  return is_asked_again(index) && index / one_asked_again_of < of_each_family;
}

void ask_again(Examinee& examinee, std::uint64_t task, Session& session, const std::vector<Asked>& asked,
               SubjectTally& tally) {
  if (asked.empty()) {
    return;
  }
  std::vector<Collision> questions{invalid_collision()};
  for (auto one = asked.rbegin(); one != asked.rend(); ++one) {
    questions.push_back(one->one.collision);
  }
  const std::vector<Answer> again = answers_of(session, questions);
  if (const auto named = verdict_on_failure(examinee.claim, {questions[0]}, again[0])) {
    tally.add(asked.back().family, asked.back().index, {questions[0]}, again[0], *named);
  }
  const Sameness sameness = sameness_of_answers(examinee.subject);
  for (const Invariant* invariant : examinee.claim.invariants) {
    const auto* about = std::get_if<AboutSession>(&invariant->about);
    for (std::size_t i = 0; about != nullptr && i < asked.size(); ++i) {
      const Asked& first = asked[asked.size() - 1 - i];
      if (!examinee.claim.is_made_in(*invariant, *examinee.families[first.family])) {
        continue;
      }
      const NamedVerdict named{invariant, about->check(first.answer, again[i + 1], sameness)};
      if (examinee.ends_at_first && named.verdict.status == Status::violated) {
        Judgement judgement;
        judgement.verdicts.push_back(named);
        examinee.first_violation = {task, first, std::move(judgement), false};
        return;
      }
      tally.add(first.family, first.index, first.one, first.answer, named);
    }
  }
}

namespace {

/// The answers of a subject in a task, and the trials that judge them.
struct Exchange {
  Batch answers;  // to the cases
  std::vector<Trial> trials;
  Batch replies;  // to the questions of the trials, in order
  double nanoseconds_per_solve;
};

/// If the session fails, the trials ask no questions.
Exchange exchange_of(Examinee& examinee, const Task& task, const std::deque<JudgedCase>& cases) {
  std::vector<Collision> collisions;
  collisions.reserve(cases.size());
  for (const JudgedCase& one : cases) {
    collisions.push_back(one.generated().collision);
  }
  const auto start = std::chrono::steady_clock::now();
  Exchange exchange{batch_of(examinee.session, collisions), {}, {}, 0};
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
  exchange.nanoseconds_per_solve = elapsed.count() / static_cast<double>(collisions.size());

  const auto trials_of = [&](bool with_relations) {
    std::vector<Trial> trials;
    trials.reserve(exchange.answers.answers.size());
    for (std::size_t i = 0; i < exchange.answers.answers.size(); ++i) {
      trials.emplace_back(cases[i], examinee.claim, lift(exchange.answers.answers[i]),
                          with_relations ? RelationTurn{examinee.relations_every, task.case_number(i)} : no_relations);
    }
    return trials;
  };
  exchange.trials = trials_of(!exchange.answers.failure);
  const std::vector<Collision> questions = questions_of(exchange.trials);
  if (!questions.empty()) {
    exchange.replies = batch_of(examinee.session, questions);
  }
  if (exchange.replies.failure) {
    exchange.trials = trials_of(false);
  }
  return exchange;
}

/// Adds the violations of questions that the subject failed to answer.
void add_failed_replies(const Trial& trial, std::span<const Answer> replies, const Claim& claim, std::size_t family,
                        std::uint64_t index, SubjectTally& tally) {
  const auto is_failed = [](const Answer& reply) { return std::holds_alternative<Failed>(reply); };
  if (!std::ranges::any_of(replies, is_failed)) {
    return;
  }
  const std::vector<Collision> questions = trial.questions();
  for (std::size_t k = 0; k < replies.size(); ++k) {
    const Case question{questions[k]};
    if (const auto named = verdict_on_failure(claim, question, replies[k])) {
      tally.add(family, index, question, replies[k], *named);
    }
  }
}

}  // namespace

void judge_task(Examinee& examinee, const Task& task, const std::deque<JudgedCase>& of_every_subject,
                SubjectTally& tally) {
  const Claim& claim = examinee.claim;
  const Family& family = *examinee.families[task.family];
  const std::deque<JudgedCase> own = with_effects(claim, of_every_subject);
  const std::deque<JudgedCase>& cases = own.empty() ? of_every_subject : own;
  const Exchange exchange = exchange_of(examinee, task, cases);
  std::span<const Answer> rest = exchange.replies.answers;
  std::vector<Asked> asked_again;
  for (std::size_t i = 0; i < exchange.trials.size(); ++i) {
    const Trial& trial = exchange.trials[i];
    const Case& one = cases[i].generated();
    const Answer& answer = exchange.answers.answers[i];
    const std::uint64_t index = task.case_number(i);
    const std::span<const Answer> replies = rest.first(trial.question_count());
    rest = rest.subspan(replies.size());
    Judgement judgement = trial.judge(replies, tally.families[task.family].worst_backward_error);
    drop_unclaimed(judgement, claim, family);
    if (examinee.ends_at_first && cut_after_violation(judgement)) {
      examinee.first_violation = {task.number, {task.family, index, one, answer}, std::move(judgement), true};
      return;
    }
    oracles::on_collision(one.collision, [&] {
      tally.add(task.family, index, cases[i], answer, judgement, claim);
      keep_if_least(tally.families[task.family].boundary, boundary_by(family, index, one.collision, judgement));
    });
    add_failed_replies(trial, replies, claim, task.family, index, tally);
    if (is_asked_again(index)) {
      asked_again.push_back({task.family, index, one, answer});
    }
    if (is_remembered(index, tally.families.size())) {
      examinee.remembered.push_back({task.family, index, one, answer});
    }
  }
  for (const std::exception_ptr& failure : {exchange.answers.failure, exchange.replies.failure}) {
    if (failure) {
      std::rethrow_exception(failure);
    }
  }
  tally.nanoseconds_per_solve.add(exchange.nanoseconds_per_solve);
  ask_again(examinee, task.number, examinee.session, asked_again, tally);
}

namespace {

constexpr std::uint64_t most_cases_in_task = 50;

}  // namespace

Schedule::Schedule(const GateOptions& options) : shard_(options.shard) {
  for (std::size_t family = 0; family < options.families.size(); ++family) {
    places_.push_back({family, static_cast<std::uint64_t>(options.families[family]->weight),
                       cases_of(options, *options.families[family])});
  }
  std::stable_sort(places_.begin(), places_.end(), [&](const Place& x, const Place& y) {
    return options.families[x.family]->turn < options.families[y.family]->turn;
  });
  if (!places_.empty()) {
    start_turn();
  }
}

void Schedule::start_turn() {
  Place& place = places_[turn_];
  place.turn_end = std::min(place.drawn + cases_in_turn_ * place.weight, place.cases);
}

std::optional<Task> Schedule::next() {
  const std::lock_guard lock(mutex_);
  const auto is_done = [](const Place& place) { return place.drawn == place.cases; };
  if (std::all_of(places_.begin(), places_.end(), is_done)) {
    return std::nullopt;
  }
  while (places_[turn_].drawn == places_[turn_].turn_end) {
    if (++turn_ == places_.size()) {
      turn_ = 0;
      cases_in_turn_ = std::min(2 * cases_in_turn_, most_cases_in_task);
    }
    start_turn();
  }
  Place& place = places_[turn_];
  const std::uint64_t first = place.drawn;
  place.drawn = std::min(first + most_cases_in_task, place.turn_end);
  return Task{next_number_++, place.family, first, place.drawn, shard_};
}

}  // namespace carom::properties
