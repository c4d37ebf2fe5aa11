// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/oracles/filters/closeness.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/properties/invariants/proof.hpp>

namespace carom::properties {

enum class Status {
  holds,
  violated,
  skipped,  // outside the invariant's domain, or the case could not be given to the subject
};

/// The decision of one invariant on one answer.
struct Verdict {
  Status status = Status::holds;
  std::string detail;  // set if violated or skipped: the comparison, or the reason for the skip
  // The members below are set if an outcome violates the invariant. If it violates several equations, they are of the
  // equation with the largest ratio of residual to allowance.
  double residual = 0;
  double allowed = 0;
  std::vector<double> left;  // both sides of the formula
  std::vector<double> right;
  bool is_undecided = false;  // set if skipped: inside the domain, but beyond the range of numbers

  /// The residual divided by the allowance if violated. Infinite if there are no such numbers, and 0 if not violated.
  [[nodiscard]] double severity() const;

  /// The residual, relative to the largest compared number. 0 if not violated, or if nothing was compared.
  [[nodiscard]] double relative_residual() const;
};

/// The size of the error in a case, as one order for all verdicts of an invariant. It is the severity if rounding is
/// allowed. If no rounding is allowed, it is the residual in units of 2⁻⁵³ L. L is the largest velocity or angular
/// velocity of the collision or compared number, or 1 if all are zero. A rounding error therefore does not rank above a
/// wrong outcome, even if no rounding is allowed.
[[nodiscard]] double seriousness(const Verdict& verdict, const Collision& collision);

/// A lifted answer. An outcome with a number that is not finite cannot be lifted.
struct NotFinite {};
using ExactAnswer = std::variant<oracles::LiftedOutcome, NotFinite, Skipped, Refused, Failed>;
[[nodiscard]] ExactAnswer lift(const Answer& answer);
/// Lifts in place, because an answer is large to move.
void lift(const Answer& answer, ExactAnswer& into);

/// A further collision that an invariant asks about, with exact facts about it and the answer to it.
struct Related {
  const oracles::ExactCase& exact_case;
  const ExactAnswer& answer;
};

/// The input of an invariant: one subject's outcome of one valid collision.
struct Evidence {
  const oracles::ExactCase& exact_case;
  bool convex_uniform;  // from the case: C ⪯ 16 λI is claimed
  Law law;
  const oracles::Yardstick& yardstick;
  const oracles::LiftedOutcome& outcome;
  const oracles::Accuracy* accuracy;    // of the outcome; nullptr for laws without a truth
  const oracles::Closeness& closeness;  // of the outcome to the truth

  [[nodiscard]] double allowance() const { return yardstick.allowance(); }
};

/// An invariant of the answer itself, to a valid or to an invalid collision.
struct AboutAnswer {
  bool to_valid;
  Verdict (*check)(const Collision&, const ExactAnswer&, Law);
};

/// An invariant of the outcome of a valid collision.
struct AboutOutcome {
  Verdict (*check)(const Evidence&);
};

/// An invariant of the collision matrix that a subject shows with the outcome of a valid collision. Only subjects that
/// show one claim it.
struct AboutMatrix {
  Verdict (*check)(const Evidence&);
  /// Whether it depends on the bodies' shapes, which the family knows. If the collision is changed, the shapes are
  /// unknown.
  bool rests_on_shapes = false;
};

/// An invariant that relates the outcome to the outcomes of further collisions. These collisions are made from the
/// collision alone or with the outcome, and the subject answers them. `check` gets one answer for each of them.
struct AboutRelation {
  using OfCollision = std::vector<Collision> (*)(const Collision&);
  using OfOutcome = std::vector<Collision> (*)(const Collision&, const Outcome<double>&);

  std::variant<OfCollision, OfOutcome> ask;
  Verdict (*check)(const Evidence&, std::span<const Related>);
};

/// The condition for two answers to be the same.
enum class Sameness {
  of_bits,
  of_numbers,  // 0 equals −0, and NaN equals NaN
};

/// A program answers in text, in which equal numbers have several spellings. All other subjects answer in bits.
[[nodiscard]] inline Sameness sameness_of_answers(const Subject& subject) {
  return subject.is_program() ? Sameness::of_numbers : Sameness::of_bits;
}

/// An invariant of sessions: it compares the first answer to a collision with a repeated answer.
struct AboutSession {
  Verdict (*check)(const Answer& first, const Answer& again, Sameness sameness);
};

/// The rank of an invariant that explains no other.
inline constexpr int explains_none = 1000;

/// A named statement about a collision and its outcome, with its source, domain, models, check and proof.
struct Invariant {
  std::string_view name;
  std::string_view statement;  // one sentence
  std::string_view formula;    // LaTeX
  std::string_view source;
  std::string_view domain;  // the collisions to which it applies
  std::vector<Law> laws;    // the laws for which it is claimed
  std::variant<AboutAnswer, AboutOutcome, AboutMatrix, AboutRelation, AboutSession> about;
  Proof proof = {};
  /// If several invariants are violated, the one with the lowest rank explains the others.
  int rank_as_cause = explains_none;

  /// Whether it asks the subject about further collisions.
  [[nodiscard]] bool asks() const { return std::holds_alternative<AboutRelation>(about); }

  /// Whether it is about one answer alone.
  [[nodiscard]] bool is_of_one_answer() const {
    return std::holds_alternative<AboutAnswer>(about) || std::holds_alternative<AboutOutcome>(about) || is_of_matrix();
  }

  /// Whether it is about the collision matrix that a subject shows.
  [[nodiscard]] bool is_of_matrix() const { return std::holds_alternative<AboutMatrix>(about); }

  /// Whether it is about the memory of a session.
  [[nodiscard]] bool is_of_session() const { return std::holds_alternative<AboutSession>(about); }

  /// Whether it is about invalid collisions.
  [[nodiscard]] bool is_of_invalid() const;

  [[nodiscard]] bool claimed_for(Law law) const;

  /// The laws for which it is claimed and proved. Empty if it is only tested.
  [[nodiscard]] std::vector<Law> proved_laws() const;
};

/// The catalogue, in its fixed order.
[[nodiscard]] std::span<const Invariant> all_invariants();

/// The invariant of this name, or nullptr if there is none.
[[nodiscard]] const Invariant* invariant_named(std::string_view name);

}  // namespace carom::properties
