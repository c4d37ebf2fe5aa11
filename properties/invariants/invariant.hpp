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
  skipped,  // outside the invariant's domain, or the case could not be posed to the subject
};

/// What one invariant says of one answer.
struct Verdict {
  Status status = Status::holds;
  std::string detail;  // where violated or skipped: what was compared, or why not
  // Where violated by an outcome; of several laws, the one that is missed most relative to what is allowed:
  double residual = 0;
  double allowed = 0;
  std::vector<double> left;  // both sides of the formula
  std::vector<double> right;
  bool is_undecided = false;  // where skipped: inside the domain, but beyond the range of numbers

  /// Residual over what is allowed where violated; infinite where no number tells, 0 where not violated.
  [[nodiscard]] double severity() const;

  /// The residual, relative to the largest number that was compared; 0 where not violated, or nothing was compared.
  [[nodiscard]] double relative_residual() const;
};

/// How badly a case is answered, as one order for all verdicts of an invariant: the severity; where nothing is allowed,
/// the residual in units of 2⁻⁵³ of the largest velocity or spin of the collision and number that was compared, or of 1
/// where nothing moves. So rounding, where even that is too much, does not pass for worse than an outcome that is
/// wrong.
[[nodiscard]] double seriousness(const Verdict& verdict, const Collision& collision);

/// An answer, lifted: an outcome that is not finite cannot be.
struct NotFinite {};
using ExactAnswer = std::variant<oracles::LiftedOutcome, NotFinite, Skipped, Refused, Failed>;
[[nodiscard]] ExactAnswer lift(const Answer& answer);
/// The same in place: an answer is large to move.
void lift(const Answer& answer, ExactAnswer& into);

/// A further collision that an invariant asks about, and what is exactly known of it.
struct Related {
  const oracles::ExactCase& exact_case;
  const ExactAnswer& answer;
};

/// What an invariant sees: one subject's outcome of one valid collision.
struct Evidence {
  const oracles::ExactCase& exact_case;
  bool convex_uniform;  // of the case: C ⪯ 16 λI is claimed
  Law law;
  const oracles::Yardstick& yardstick;
  const oracles::LiftedOutcome& outcome;
  const oracles::Accuracy* accuracy;    // of the outcome; nullptr for laws without a truth
  const oracles::Closeness& closeness;  // of the outcome to the truth

  [[nodiscard]] double allowance() const { return yardstick.allowance(); }
};

/// An invariant that speaks of the answer itself, to a valid collision or to an invalid one.
struct AboutAnswer {
  bool to_valid;
  Verdict (*check)(const Collision&, const ExactAnswer&, Law);
};

/// One that speaks of the outcome of a valid collision.
struct AboutOutcome {
  Verdict (*check)(const Evidence&);
};

/// One that speaks of the collision matrix that a subject shows with the outcome of a valid collision. It is claimed by
/// subjects that show one.
struct AboutMatrix {
  Verdict (*check)(const Evidence&);
  /// Whether it rests on what the family knows of the bodies' shapes. Nothing is known of a collision that is changed.
  bool rests_on_shapes = false;
};

/// One that relates the outcome to those of further collisions, which are put to the subject: made from the collision
/// alone, or with the outcome. `check` gets the answers to these, one each.
struct AboutRelation {
  using OfCollision = std::vector<Collision> (*)(const Collision&);
  using OfOutcome = std::vector<Collision> (*)(const Collision&, const Outcome<double>&);

  std::variant<OfCollision, OfOutcome> ask;
  Verdict (*check)(const Evidence&, std::span<const Related>);
};

/// When two answers are the same.
enum class Sameness {
  of_bits,
  of_numbers,  // 0 and −0 are one number, and NaN is as NaN
};

/// A program answers in text, in which equal numbers have several spellings. All other subjects answer in bits.
[[nodiscard]] inline Sameness sameness_of_answers(const Subject& subject) {
  return subject.is_program() ? Sameness::of_numbers : Sameness::of_bits;
}

/// One about sessions: the answers to one collision, asked first and asked again.
struct AboutSession {
  Verdict (*check)(const Answer& first, const Answer& again, Sameness sameness);
};

/// The rank of an invariant that explains no other.
inline constexpr int explains_none = 1000;

/// A named statement about a collision and its outcome, and all that is known of it.
struct Invariant {
  std::string_view name;
  std::string_view statement;  // one sentence
  std::string_view formula;    // LaTeX
  std::string_view source;
  std::string_view domain;  // the collisions that it speaks of
  std::vector<Law> laws;    // that it is claimed for
  std::variant<AboutAnswer, AboutOutcome, AboutMatrix, AboutRelation, AboutSession> about;
  Proof proof = {};
  /// If several are violated, the one of the least rank explains the others.
  int rank_as_cause = explains_none;

  /// Whether it puts further collisions to the subject.
  [[nodiscard]] bool asks() const { return std::holds_alternative<AboutRelation>(about); }

  /// Whether it speaks of one answer alone.
  [[nodiscard]] bool is_of_one_answer() const {
    return std::holds_alternative<AboutAnswer>(about) || std::holds_alternative<AboutOutcome>(about) || is_of_matrix();
  }

  /// Whether it speaks of the collision matrix that a subject shows.
  [[nodiscard]] bool is_of_matrix() const { return std::holds_alternative<AboutMatrix>(about); }

  /// Whether it speaks of what a session remembers.
  [[nodiscard]] bool is_of_session() const { return std::holds_alternative<AboutSession>(about); }

  /// Whether it speaks of invalid collisions.
  [[nodiscard]] bool is_of_invalid() const;

  [[nodiscard]] bool claimed_for(Law law) const;

  /// The laws, of those that it is claimed for, of which it is proved; empty where it is tested alone.
  [[nodiscard]] std::vector<Law> proved_laws() const;
};

/// The catalogue, in the order of the design.
[[nodiscard]] std::span<const Invariant> all_invariants();

/// The invariant of this name; nullptr where there is none.
[[nodiscard]] const Invariant* invariant_named(std::string_view name);

}  // namespace carom::properties
