// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <carom/collision/expects.hpp>
#include <carom/oracles/bounds/lazy.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/properties/cases/domain.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/properties/gate/unjudged.hpp>
#include <carom/properties/invariants/invariant.hpp>

namespace carom::properties {

/// The law, the yardstick and the invariants by which a subject is judged.
struct Claim {
  Law law = Law::any;
  oracles::Yardstick yardstick = oracles::Yardstick::of_exact_arithmetic();
  /// The invariants that are claimed for the law, without those that the subject deviates from in all families.
  /// Invariants about the collision matrix are included only if the subject shows its matrix.
  std::vector<const Invariant*> invariants;
  std::vector<Deviation> deviations = {};  // in all families, and in single families
  /// A relation is not judged if one of its questions lies outside of this domain. Questions lie in its kinds if they
  /// can.
  Domain within = {};
  DeclaredEffects effects = {};

  /// Whether no deviation excludes the invariant in this family.
  [[nodiscard]] bool is_made_in(const Invariant& invariant, const Family& family) const;
};

/// The invariants that the subject does not claim because it shows no collision matrix. Empty if it shows its matrix.
[[nodiscard]] std::vector<const Invariant*> not_claimed_without_matrix(const Subject& subject);

/// The claim of a subject. Ignores a deviation whose invariant or family does not exist.
[[nodiscard]] Claim claim_of(const Subject& subject, const oracles::Limits& limits);

/// Checks the limits. Throws std::invalid_argument unless `limit_ulps` is positive and finite, and `digits`
/// is from 1 to 18.
[[nodiscard]] oracles::Limits limits_with(double limit_ulps, std::optional<int> digits);

/// A case with exact facts, shared by all subjects that are judged on the case. For one thread.
class JudgedCase {
 public:
  /// If `filtered` is false, exact arithmetic alone decides the facts. `effects` are those that the judged subjects
  /// declare.
  explicit JudgedCase(const Case& generated, bool filtered = true, const DeclaredEffects& effects = {});

  /// The case that subjects answer.
  [[nodiscard]] const Case& generated() const { return generated_; }
  [[nodiscard]] bool is_valid() const { return exact_.has_value(); }
  [[nodiscard]] const DeclaredEffects& effects() const { return effects_; }

  /// The facts of `judged_collision`. Precondition: is_valid().
  [[nodiscard]] const oracles::ExactCase& exact() const {
    CAROM_EXPECTS(is_valid());
    return *exact_;
  }

  /// The questions of an invariant: related collisions that the subject must answer too. All subjects get the same
  /// questions. Empty if one of the questions is not a valid collision. Preconditions: is_valid(); `invariant.about` is
  /// an AboutRelation whose `ask` is an OfCollision; every call for this case has the same kinds.
  [[nodiscard]] std::span<const oracles::ExactCase> questions_of(const Invariant& invariant,
                                                                 const Kinds& kinds = {}) const;

  /// The effects of approach that decide the case, if the posed collision collides. Precondition: is_valid().
  [[nodiscard]] EffectFlags decided_by_approach(const oracles::Yardstick& yardstick) const;
  /// Whether the posed collision collides. Precondition: is_valid().
  [[nodiscard]] bool collides() const;

  /// `oracles::coulomb_answers` of the case. Precondition: is_valid().
  [[nodiscard]] const std::vector<oracles::CoulombAnswer>& coulomb_answers() const {
    return coulomb_answers_.get([this] { return oracles::coulomb_answers(exact()); });
  }

  /// `reason_unjudged` of the case. Precondition: is_valid().
  [[nodiscard]] std::optional<Unjudged> reason_unjudged_by(const oracles::Yardstick& yardstick) const;
  /// Whether each question of the invariant is judged. Preconditions: those of `questions_of`.
  [[nodiscard]] bool are_questions_judged_by(const oracles::Yardstick& yardstick, const Invariant& invariant,
                                             const Kinds& kinds = {}) const;

 private:
  /// A result for each pair of unit roundoff and allowance.
  template <class T>
  using PerYardstick = std::vector<std::pair<std::pair<double, double>, T>>;
  struct Questions {
    std::vector<oracles::ExactCase> cases;
    mutable PerYardstick<bool> are_judged;
  };

  /// `at_declared_limit` of the posed collision.
  [[nodiscard]] EffectFlags at_limit(const oracles::Yardstick& yardstick) const;
  [[nodiscard]] const Questions& questions_and_results_of(const Invariant& invariant, const Kinds& kinds) const;

  Case generated_;
  bool filtered_;
  DeclaredEffects effects_;
  std::optional<oracles::ExactCase> exact_;
  oracles::LazyMap<const Invariant*, Questions> questions_;
  mutable PerYardstick<std::optional<Unjudged>> unjudged_;
  oracles::Lazy<std::vector<oracles::CoulombAnswer>> coulomb_answers_;
};

struct NamedVerdict {
  const Invariant* invariant;
  Verdict verdict;
};

struct Judgement {
  std::vector<NamedVerdict> verdicts;
  std::optional<oracles::Accuracy> accuracy;  // set if the answer is an outcome and the law has a truth
  std::optional<Skipped> skipped;             // set if the case could not be given to the subject
  std::optional<Unjudged> unjudged;           // set if the case is not judged; `verdicts` is then empty
  EffectFlags decided_by{};                   // the declared effects that decide the case; none if it does not collide
};

/// Selects the relations that are judged on a case. Each relation is judged on one case in `every`, and different
/// relations on different cases.
struct RelationTurn {
  std::uint64_t every = 1;   // 0: no relation is judged
  std::uint64_t number = 0;  // of the case

  /// Whether the relation at this index of `Claim::invariants` is judged.
  [[nodiscard]] bool has(std::size_t place) const { return every > 0 && (number + place) % every == 0; }
};
inline constexpr RelationTurn no_relations{0, 0};

/// A trial judges a subject's answer to a case by every invariant that the subject claims. It has two steps,
/// `questions` and `judge`, so a subject can answer the questions of many trials at once. Its constructor and `judge`
/// throw JudgeError if the judge fails.
class Trial {
 public:
  /// `answer` is the subject's answer to the case. `judged_case` and `claim` must outlive the trial. Precondition: the
  /// case and the claim have the same declared effects.
  Trial(const JudgedCase& judged_case, const Claim& claim, ExactAnswer answer, RelationTurn relations = {});

  // The trial refers to questions that it stores, so it cannot be copied.
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  Trial(Trial&&) = default;
  Trial& operator=(Trial&&) = default;
  ~Trial() = default;

  /// The questions of the claimed invariants, in order.
  [[nodiscard]] std::vector<Collision> questions() const;
  /// Appends them to `all`.
  void add_questions(std::vector<Collision>& all) const;
  [[nodiscard]] std::size_t question_count() const;

  /// Judges the case by the answers to its questions. Throws std::invalid_argument unless there is one answer to each
  /// question. `known_backward_error` is the maximum so far. If the backward error is certainly at most this maximum,
  /// the judgement may state a larger value up to it. So a maximum over many judgements needs few precise values. The
  /// verdicts do not depend on it.
  [[nodiscard]] Judgement judge(std::span<const Answer> answers, double known_backward_error = 0) const;
  /// Takes the declared effects out of the answers.
  [[nodiscard]] Judgement judge(std::span<ExactAnswer> answers, double known_backward_error = 0) const;

 private:
  /// Takes the declared effects out of the answer, and makes the questions. Precondition: the answer is an outcome of a
  /// valid collision.
  void prepare();
  template <class AnswersTo>
  [[nodiscard]] Judgement judge_by(const AnswersTo& answers_to, double known_backward_error) const;
  template <class AnswersTo>
  void add_verdicts(Judgement& judgement, const AnswersTo& answers_to, double known_backward_error) const;
  /// The verdict of an invariant of one outcome; none for other invariants.
  [[nodiscard]] std::optional<Verdict> verdict_on_outcome(const Invariant& invariant, const Evidence& evidence) const;
  template <class AnswersTo>
  [[nodiscard]] Verdict verdict_on_relation(const Invariant& invariant, std::span<const oracles::ExactCase> questions,
                                            const Evidence& evidence, const AnswersTo& answers_to) const;

  [[nodiscard]] EffectFlags decided_by() const;
  void require_one_answer_each(std::size_t count) const;
  [[nodiscard]] std::size_t most_questions() const;  // of one invariant

  const JudgedCase* judged_case_;
  const Claim* claim_;
  ExactAnswer answer_;
  RelationTurn relations_;
  EffectFlags limited_;                                         // by `take_out_effects`
  std::vector<std::vector<oracles::ExactCase>> by_outcome_;     // the questions that depend on the outcome
  std::vector<std::span<const oracles::ExactCase>> questions_;  // of each claimed invariant
};

/// Judges an answer by the claimed invariants that need no further answer. `known_backward_error` is that of
/// Trial::judge. Precondition: that of Trial.
[[nodiscard]] Judgement judge_answer(const JudgedCase& judged_case, const Claim& claim, ExactAnswer answer,
                                     double known_backward_error = 0);

/// A solver with lifted answers, such as a solver in ℚ.
using ExactSolve = std::function<ExactAnswer(const Collision&)>;

[[nodiscard]] Judgement try_case(const JudgedCase& judged_case, const Claim& claim, const ExactSolve& solve);

}  // namespace carom::properties
