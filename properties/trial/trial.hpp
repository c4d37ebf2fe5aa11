// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <carom/collision/expects.hpp>
#include <carom/properties/families/family.hpp>
#include <carom/properties/invariants/invariant.hpp>
#include <carom/properties/trial/deviation.hpp>
#include <carom/properties/trial/unjudged.hpp>

/// Gives one case (a drawn collision) to one subject (a solver under test). Judges the answer by every invariant that
/// the subject claims.
namespace carom::properties {

/// The law, the yardstick (the rounding that is allowed) and the invariants by which a subject is judged.
struct Claim {
  Law law = Law::any;
  oracles::Yardstick yardstick;
  /// The invariants that are claimed for the law. The list excludes those that the subject deviates from in all
  /// families, and those of a matrix that it does not show.
  std::vector<const Invariant*> invariants;
  std::vector<Deviation> deviations = {};  // all deviations, including those in single families: a trial does not know
                                           // the family of its case

  [[nodiscard]] bool is_made_in(const Invariant& invariant, const Family& family) const;
};

/// The invariants of the collision matrix that are claimed for the subject's law but cannot be judged. The list is
/// empty if the subject shows its matrix.
[[nodiscard]] std::vector<const Invariant*> not_claimed_without_matrix(const Subject& subject);

/// The claim of the subject. The function ignores a deviation whose invariant or family does not exist.
[[nodiscard]] Claim claim_of(const Subject& subject, oracles::Yardstick yardstick);

/// A case, with exact facts about it and about the collisions related to it. All subjects that are judged on the case
/// share it. For one thread.
class JudgedCase {
 public:
  /// If `filtered` is false, the facts about the collisions are decided in ℚ alone, without filters.
  explicit JudgedCase(const Case& generated, bool filtered = true);

  [[nodiscard]] const Case& generated() const { return generated_; }
  [[nodiscard]] bool is_valid() const { return exact_.has_value(); }

  /// Precondition: is_valid().
  [[nodiscard]] const oracles::ExactCase& exact() const {
    CAROM_EXPECTS(is_valid());
    return *exact_;
  }

  /// The related collisions of an invariant that do not depend on the outcome, with exact facts about them. They are
  /// kept, because every subject gets the same questions. The result is empty if one of them is not valid, for example
  /// if the relation takes an extreme case out of range. Preconditions: is_valid(); `invariant.about` is an
  /// AboutRelation whose `ask` is an OfCollision.
  [[nodiscard]] std::span<const oracles::ExactCase> questions_of(const Invariant& invariant) const;

  /// `reason_unjudged` of the collision, and whether every question of `questions_of` is judged. Both results are kept
  /// for each unit roundoff and allowance. Preconditions: is_valid(), and those of `questions_of`.
  [[nodiscard]] std::optional<Unjudged> reason_unjudged_by(const oracles::Yardstick& yardstick) const;
  [[nodiscard]] bool are_questions_judged_by(const oracles::Yardstick& yardstick, const Invariant& invariant) const;

 private:
  /// Results for each unit roundoff and allowance. There are few of these pairs.
  template <class T>
  using PerYardstick = std::vector<std::pair<std::pair<double, double>, T>>;
  struct Questions {
    std::vector<oracles::ExactCase> cases;
    PerYardstick<bool> are_judged;
  };

  Case generated_;
  bool filtered_;
  std::optional<oracles::ExactCase> exact_;
  mutable std::map<const Invariant*, Questions> questions_;
  mutable PerYardstick<std::optional<Unjudged>> unjudged_;
};

/// The verdict of one invariant.
struct NamedVerdict {
  const Invariant* invariant;
  Verdict verdict;
};

/// The result of a trial.
struct Judgement {
  std::vector<NamedVerdict> verdicts;
  std::optional<oracles::Accuracy> accuracy;  // of an outcome, if the law has a truth
  std::optional<Skipped> skipped;             // set if the case could not be given to the subject
  std::optional<Unjudged> unjudged;           // the reason why the case is not judged; then there are no verdicts
};

/// Selects the relations (invariants about related collisions) that are judged on a case. Each relation is judged on
/// one case in `every`. The next relation is judged on other cases, so that every case is judged by some relations.
struct RelationTurn {
  std::uint64_t every = 1;   // 0: none of the invariants on any case
  std::uint64_t number = 0;  // number of the case

  /// Whether the invariant at this place of `Claim::invariants` is judged.
  [[nodiscard]] bool has(std::size_t place) const { return every > 0 && (number + place) % every == 0; }
};
inline constexpr RelationTurn no_relations{0, 0};

/// A trial in two steps, `questions` and `judge`, so that a subject can get the questions of many trials at once.
class Trial {
 public:
  /// `answer` is the subject's answer to the case's collision. `relations` selects the invariants about related
  /// collisions.
  Trial(const JudgedCase& judged_case, const Claim& claim, ExactAnswer answer, RelationTurn relations = {});

  // A trial is not copyable, because it refers to questions that it stores itself.
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  Trial(Trial&&) = default;
  Trial& operator=(Trial&&) = default;
  ~Trial() = default;

  /// The related collisions for the claimed invariants.
  [[nodiscard]] std::vector<Collision> questions() const;
  [[nodiscard]] std::size_t question_count() const;

  /// If the backward error is certainly at most `known_backward_error`, the judgement may state a larger value within
  /// this limit (oracles::accuracy). A maximum over many judgements therefore needs few precise values. The verdicts do
  /// not depend on the limit. Precondition: there is one answer to each question, in order.
  [[nodiscard]] Judgement judge(std::span<const Answer> answers, double known_backward_error = 0) const;
  [[nodiscard]] Judgement judge(std::span<const ExactAnswer> answers, double known_backward_error = 0) const;

 private:
  template <class AnswersTo>
  [[nodiscard]] Judgement judge_by(const AnswersTo& answers_to, double known_backward_error) const;

  void require_one_answer_each(std::size_t count) const;
  [[nodiscard]] std::size_t most_questions() const;  // for one invariant

  const JudgedCase* judged_case_;
  const Claim* claim_;
  ExactAnswer answer_;
  RelationTurn relations_;
  std::vector<std::vector<oracles::ExactCase>> by_outcome_;     // for the invariants whose questions depend on the
                                                                // outcome
  std::vector<std::span<const oracles::ExactCase>> questions_;  // for each claimed invariant
};

/// A solver that returns lifted answers, so that solvers in ℚ can be judged too.
using ExactSolve = std::function<ExactAnswer(const Collision&)>;

/// Runs the whole trial of one case.
[[nodiscard]] Judgement try_case(const JudgedCase& judged_case, const Claim& claim, const ExactSolve& solve);

}  // namespace carom::properties
