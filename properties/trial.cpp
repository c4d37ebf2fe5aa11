// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <carom/collision/validate.hpp>
#include <carom/properties/trial.hpp>

namespace carom::properties {
namespace {

bool same_numbers(const Collision& left, const Collision& right) {
  bool same = left.a.immovable == right.a.immovable && left.b.immovable == right.b.immovable;
  if (same) {
    for_each_number([&](const FieldPath&, const double& x, const double& y) { same = same && x == y; }, left, right);
  }
  return same;
}

Verdict violated(std::string detail) { return {Status::violated, std::move(detail), 0, 0, {}, {}}; }

/// `finite`, of the answer to a valid collision.
Verdict finite(const ExactAnswer& answer) {
  if (std::holds_alternative<NotFinite>(answer)) {
    return violated("the outcome is not finite");
  }
  if (const auto* refused = std::get_if<Refused>(&answer)) {
    return violated("a valid collision was refused: " + refused->why);
  }
  return {};
}

/// Whether a collision is invalid only by fields that no law judged here reads: friction is the law `rough`'s alone.
bool is_invalid_by_friction_alone(const Collision& collision) {
  Collision without = collision;
  without.friction = 0;
  without.tangential_restitution = 0;
  return validate(without).empty();
}

/// `invalid_refused`, of the answer to an invalid collision.
Verdict invalid_refused(const Collision& collision, const ExactAnswer& answer) {
  if (std::holds_alternative<Refused>(answer)) {
    return {};
  }
  if (is_invalid_by_friction_alone(collision)) {
    return {Status::skipped, "the model does not read the field that is invalid", 0, 0, {}, {}};
  }
  return violated("an invalid collision was answered");
}

oracles::Closeness closeness_of(const JudgedCase& judged_case, const Claim& claim,
                                const oracles::LiftedOutcome* outcome,
                                const std::optional<oracles::Accuracy>& accuracy) {
  const bool is_bounded = accuracy && accuracy->is_decided && claim.yardstick.uses_bounds() &&
                          judged_case.exact().is_moderate() && outcome->is_moderate();
  return is_bounded ? oracles::Closeness(judged_case.exact(), *outcome, *accuracy, claim.yardstick.allowance())
                    : oracles::Closeness();
}

}  // namespace

Claim claim_of(const Subject& subject, oracles::Yardstick yardstick) {
  yardstick.unit_roundoff = unit_roundoff(subject.precision);
  Claim claim{subject.model, yardstick, {}};
  for (const Invariant& invariant : all_invariants()) {
    const bool deviates =
        std::find(subject.deviates.begin(), subject.deviates.end(), invariant.name) != subject.deviates.end();
    if (invariant.claimed_for(subject.model) && !deviates) {
      claim.invariants.push_back(&invariant);
    }
  }
  return claim;
}

JudgedCase::JudgedCase(const Case& generated) : generated_(generated) {
  if (validate(generated.collision).empty()) {
    exact_.emplace(generated.collision);
  }
}

const oracles::ExactCase* JudgedCase::related(const Collision& collision) const {
  for (const auto& known : related_) {
    if (same_numbers(known->collision(), collision)) {
      return known.get();
    }
  }
  if (!validate(collision).empty()) {
    return nullptr;
  }
  related_.push_back(std::make_unique<oracles::ExactCase>(collision));
  return related_.back().get();
}

Trial::Trial(const JudgedCase& judged_case, const Claim& claim, ExactAnswer answer,
             std::optional<oracles::LiftedMatrix> collision_matrix, bool with_relations)
    : judged_case_(&judged_case),
      claim_(&claim),
      answer_(std::move(answer)),
      collision_matrix_(std::move(collision_matrix)),
      with_relations_(with_relations),
      question_count_(claim.invariants.size(), 0) {
  const auto* outcome = std::get_if<oracles::LiftedOutcome>(&answer_);
  if (outcome == nullptr || !judged_case.is_valid()) {
    return;
  }
  for (std::size_t i = 0; i < claim.invariants.size(); ++i) {
    if (claim.invariants[i]->questions == nullptr || !with_relations) {
      continue;
    }
    const std::vector<Collision> asked =
        claim.invariants[i]->questions(judged_case.exact().collision(), outcome->rounded());
    const bool all_valid =
        std::all_of(asked.begin(), asked.end(), [&](const Collision& c) { return judged_case.related(c) != nullptr; });
    if (all_valid) {
      question_count_[i] = asked.size();
      questions_.insert(questions_.end(), asked.begin(), asked.end());
    }
  }
}

Judgement Trial::judge(std::span<const ExactAnswer> answers, double known_backward_error) const {
  if (answers.size() != questions_.size()) {
    throw std::invalid_argument("a trial needs one answer to each of its questions");
  }
  Judgement judgement;
  if (const auto* skipped = std::get_if<Skipped>(&answer_)) {
    judgement.skipped = *skipped;
    return judgement;
  }
  const auto* outcome = std::get_if<oracles::LiftedOutcome>(&answer_);
  const bool has_truth = claim_->model != Model::any;
  if (outcome != nullptr && judged_case_->is_valid() && has_truth) {
    judgement.accuracy =
        oracles::accuracy(judged_case_->exact(), claim_->model, *outcome, claim_->yardstick, known_backward_error);
  }
  const oracles::Closeness closeness = closeness_of(*judged_case_, *claim_, outcome, judgement.accuracy);
  judgement.verdicts.reserve(claim_->invariants.size());
  std::size_t next_question = 0;
  for (std::size_t i = 0; i < claim_->invariants.size(); ++i) {
    const Invariant& invariant = *claim_->invariants[i];
    if (invariant.check == nullptr) {
      const bool about_invalid = invariant.name == "invalid_refused";
      if (about_invalid != judged_case_->is_valid()) {
        judgement.verdicts.push_back({&invariant, about_invalid
                                                      ? invalid_refused(judged_case_->generated().collision, answer_)
                                                      : finite(answer_)});
      }
      continue;
    }
    if (outcome == nullptr || !judged_case_->is_valid() || (invariant.questions != nullptr && !with_relations_)) {
      continue;
    }
    std::vector<Related> related;
    for (std::size_t q = 0; q < question_count_[i]; ++q, ++next_question) {
      related.push_back({*judged_case_->related(questions_[next_question]), answers[next_question]});
    }
    if (invariant.questions != nullptr && related.empty()) {
      judgement.verdicts.push_back(
          {&invariant, {Status::skipped, "the related collision is out of range", 0, 0, {}, {}}});
      continue;
    }
    const Evidence evidence{judged_case_->exact(),
                            judged_case_->generated().convex_uniform,
                            claim_->model,
                            claim_->yardstick,
                            *outcome,
                            judgement.accuracy ? &*judgement.accuracy : nullptr,
                            closeness,
                            collision_matrix_ ? &*collision_matrix_ : nullptr,
                            related};
    judgement.verdicts.push_back({&invariant, invariant.check(evidence)});
  }
  return judgement;
}

Judgement try_case(const JudgedCase& judged_case, const Claim& claim, const ExactSolve& solve,
                   const std::optional<oracles::LiftedMatrix>& collision_matrix) {
  const Trial trial(judged_case, claim, solve(judged_case.generated().collision), collision_matrix);
  std::vector<ExactAnswer> answers;
  for (const Collision& question : trial.questions()) {
    answers.push_back(solve(question));
  }
  return trial.judge(answers);
}

std::optional<oracles::LiftedMatrix> shown_collision_matrix(const Subject& subject, const JudgedCase& judged_case) {
  if (!subject.collision_matrix || !judged_case.is_valid()) {
    return std::nullopt;
  }
  const Matrix3<long double> shown = subject.collision_matrix(judged_case.generated().collision);
  const bool is_finite =
      std::all_of(shown.data(), shown.data() + shown.size(), [](long double x) { return std::isfinite(x); });
  // A matrix that is not finite bounds nothing: shown as zero it violates `definite`.
  return oracles::LiftedMatrix(is_finite ? shown : Matrix3<long double>(Matrix3<long double>::Zero()));
}

}  // namespace carom::properties
