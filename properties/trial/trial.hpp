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

/// One case put to one subject and judged on every invariant that the subject claims.
namespace carom::properties {

/// What is judged about a subject.
struct Claim {
  Law law = Law::any;
  oracles::Yardstick yardstick;
  /// Claimed for the law, without those that the subject deviates from, and those of a matrix that it does not show.
  std::vector<const Invariant*> invariants;
  std::vector<Deviation> deviations = {};  // from these in single families; a trial does not know of which its case is

  [[nodiscard]] bool is_made_in(const Invariant& invariant, const Family& family) const;
};

/// What is said of the collision matrix for the subject's law, where it shows none: so it cannot be judged.
[[nodiscard]] std::vector<const Invariant*> not_claimed_without_matrix(const Subject& subject);

/// What the subject is said to deviate from and is no invariant, or in no family, is passed over.
[[nodiscard]] Claim claim_of(const Subject& subject, oracles::Yardstick yardstick);

/// A case, and what is exactly known of it and of the collisions related to it. Shared by the subjects that are judged
/// on it; for one thread.
class JudgedCase {
 public:
  /// Without the filter, also what is known of the collisions themselves is decided in ℚ alone.
  explicit JudgedCase(const Case& generated, bool filtered = true);

  [[nodiscard]] const Case& generated() const { return generated_; }
  [[nodiscard]] bool is_valid() const { return exact_.has_value(); }

  /// Precondition: is_valid().
  [[nodiscard]] const oracles::ExactCase& exact() const {
    CAROM_EXPECTS(is_valid());
    return *exact_;
  }

  /// The collisions that an invariant of the catalogue asks about whatever the outcome, and what is exactly known of
  /// them; remembered, since every subject is asked the same. None where one is not valid (an extreme case that the
  /// relation takes out of range). Preconditions: is_valid(); the invariant has `questions`.
  [[nodiscard]] std::span<const oracles::ExactCase> questions_of(const Invariant& invariant) const;

  /// `reason_unjudged` of the collision, and whether there is none for each of those questions; remembered for each
  /// unit roundoff and allowance. Preconditions: is_valid(); as of `questions_of`.
  [[nodiscard]] std::optional<Unjudged> reason_unjudged_by(const oracles::Yardstick& yardstick) const;
  [[nodiscard]] bool are_questions_judged_by(const oracles::Yardstick& yardstick, const Invariant& invariant) const;

 private:
  /// What was worked out for each unit roundoff and allowance: there are few.
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

/// What came of a trial.
struct Judgement {
  std::vector<NamedVerdict> verdicts;
  std::optional<oracles::Accuracy> accuracy;  // of an outcome, for laws with a truth
  std::optional<Skipped> skipped;             // the subject could not be posed the case
  std::optional<Unjudged> unjudged;           // why the case is not judged; then there are no verdicts
};

/// Which of the invariants that ask about further collisions are judged on a case: each on one in `every` cases, and
/// one on other cases than the next, so that every case is held against some of them.
struct RelationTurn {
  std::uint64_t every = 1;   // 0: none of them on any case
  std::uint64_t number = 0;  // of the case

  /// By the place of the invariant in its claim.
  [[nodiscard]] bool has(std::size_t place) const { return every > 0 && (number + place) % every == 0; }
};
inline constexpr RelationTurn no_relations{0, 0};

/// A trial in two steps, so that many can be put to a subject at once.
class Trial {
 public:
  /// `answer` is the subject's to the case's collision. The invariants that ask about further collisions are left out
  /// where it is not their turn.
  Trial(const JudgedCase& judged_case, const Claim& claim, ExactAnswer answer, RelationTurn relations = {});

  // It refers to questions that it holds itself.
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  Trial(Trial&&) = default;
  Trial& operator=(Trial&&) = default;
  ~Trial() = default;

  /// The related collisions that the claimed invariants ask about.
  [[nodiscard]] std::vector<Collision> questions() const;
  [[nodiscard]] std::size_t question_count() const;

  /// Where the backward error is surely at most `known`, that of the judgement may be too large, but by no more than
  /// `known`: a maximum over many judgements needs few of them (oracles::accuracy). The verdicts do not depend on it.
  /// Precondition: one answer to each question, in order.
  [[nodiscard]] Judgement judge(std::span<const Answer> answers, double known_backward_error = 0) const;
  [[nodiscard]] Judgement judge(std::span<const ExactAnswer> answers, double known_backward_error = 0) const;

 private:
  template <class AnswersTo>
  [[nodiscard]] Judgement judge_by(const AnswersTo& answers_to, double known_backward_error) const;

  void require_one_answer_each(std::size_t count) const;
  [[nodiscard]] std::size_t most_questions() const;  // of one invariant

  const JudgedCase* judged_case_;
  const Claim* claim_;
  ExactAnswer answer_;
  RelationTurn relations_;
  std::vector<std::vector<oracles::ExactCase>> by_outcome_;     // of the invariants whose questions depend on it
  std::vector<std::span<const oracles::ExactCase>> questions_;  // of each claimed invariant
};

/// Answers as exactly as it computes: lets solvers in ℚ be judged as well.
using ExactSolve = std::function<ExactAnswer(const Collision&)>;

/// A whole trial of one case.
[[nodiscard]] Judgement try_case(const JudgedCase& judged_case, const Claim& claim, const ExactSolve& solve);

}  // namespace carom::properties
