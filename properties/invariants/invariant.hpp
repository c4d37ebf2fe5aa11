// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/properties/cases/kinds.hpp>

namespace carom::properties {

enum class Status {
  holds,
  violated,
  skipped,  // the invariant does not apply, or the case could not be given to the subject
};

/// The kind of a violation. The words of a kind begin the detail of the verdict, except for `sides_differ`.
enum class ViolationKind {
  sides_differ,
  not_finite,
  refused,
  no_answer,
  failed_on_invalid,
  answered_invalid,
  related_refused,
  related_not_finite,
  another_kind_of_answer,
  matrix_in_one_answer,
  matrix_missing,
  matrix_not_finite,
  subject_failed,
  subject_threw,
};

/// The decision of one invariant on one answer.
struct Verdict {
  Status status = Status::holds;
  std::string detail = {};  // set if violated or skipped: the comparison, or the reason for the skip
  // `residual`, `allowed` (the permitted residual), `left` and `right` are set if an outcome violates the invariant. Of
  // several violated equations, they describe the one with the largest ratio of residual to permitted residual.
  double residual = 0;
  double allowed = 0;
  std::vector<double> left = {};  // both sides of the formula
  std::vector<double> right = {};
  bool is_undecided = false;  // a skip where the invariant applies, because numbers leave their range
  ViolationKind kind = ViolationKind::sides_differ;

  /// The residual divided by the permitted residual; infinite if one of them is zero. 0 if not violated.
  [[nodiscard]] double severity() const;

  /// The residual divided by the largest compared number; 0 if there is none.
  [[nodiscard]] double relative_residual() const;
};

/// A violation without sides. Its detail is the words of the kind, and then `more`.
[[nodiscard]] Verdict violation(ViolationKind kind, const std::string& more = {});

/// The kind whose words begin the detail. `sides_differ` if there is none.
[[nodiscard]] ViolationKind kind_of_detail(std::string_view detail);

/// Ranks the violations of an invariant: 0 if the invariant is not violated, infinite if the violation has no residual.
/// If rounding is permitted (`allowed` > 0), the rank is the severity. Otherwise the rank is the residual divided by
/// 2⁻⁵³ L, so a rounding error ranks below a wrong outcome. L is the largest absolute value among the compared numbers
/// and the velocities before the impulse, or 1 if all are zero.
[[nodiscard]] double seriousness(const Verdict& verdict, const Collision& collision);

/// An answer whose outcome is lifted. `NotFinite` stands for an outcome with an infinity or NaN.
struct NotFinite {};
using ExactAnswer = std::variant<oracles::LiftedOutcome, NotFinite, Skipped, Refused, Failed>;
[[nodiscard]] ExactAnswer lift(const Answer& answer);
/// Writes into `into`, because moving an answer is expensive. Leaves out the collision matrix, because no relation
/// reads the matrix of a related answer.
void lift_without_matrix(const Answer& answer, ExactAnswer& into);

/// A question, with exact facts and the answer.
struct Related {
  const oracles::ExactCase& exact_case;
  const ExactAnswer& answer;
};

/// The input of a check: a subject's outcome of one valid collision.
struct Evidence {
  const oracles::ExactCase& exact_case;
  /// Whether the family guarantees uniform convex bodies. If so, C ⪯ 16 λI, with the collision matrix C and λ = 1/m_A +
  /// 1/m_B.
  bool convex_uniform;
  Law law;
  const oracles::Yardstick& yardstick;
  const oracles::LiftedOutcome& outcome;
  const oracles::Accuracy* accuracy;  // of the outcome; nullptr for laws without a truth
  Kinds kinds = {};                   // in which the run poses collisions

  [[nodiscard]] double allowance() const { return yardstick.allowance(); }
};

/// An invariant of one answer, to a valid collision if `to_valid`, otherwise to an invalid collision.
struct AboutAnswer {
  bool to_valid;
  Verdict (*check)(const Collision&, const ExactAnswer&, Law);
};

/// An invariant of the outcome of a valid collision.
struct AboutOutcome {
  Verdict (*check)(const Evidence&);
  bool is_of_colliding = false;  // whether it applies to the outcomes of colliding contacts
  /// Whether it judges an outcome in which a declared limit may shorten a velocity.
  bool judges_limited = false;
};

/// An invariant of the collision matrix that a subject shows with its outcome of a valid collision.
struct AboutMatrix {
  Verdict (*check)(const Evidence&);
  /// Whether the invariant depends on the bodies' shapes. Only the family knows the shapes, and only those of the
  /// collision that it drew.
  bool rests_on_shapes = false;
  bool is_bound = false;  // whether it bounds the eigenvalues
};

/// A relation: an invariant that compares the outcome with the outcomes of related collisions. `ask` makes these
/// collisions, the questions. They lie in the kinds if the collision does and one can. `check` gets the subject's
/// answer to each question.
struct AboutRelation {
  using OfCollision = std::vector<Collision> (*)(const Collision&, const Kinds&);
  using OfOutcome = std::vector<Collision> (*)(const Collision&, const Outcome<double>&, const Kinds&);

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

/// An invariant of sessions: it compares the first answer to a collision with a later one.
struct AboutSession {
  Verdict (*check)(const Answer& first, const Answer& again, Sameness sameness);
};

/// A theorem that Coq checks.
struct Theorem {
  std::string_view name;
  std::string_view file;  // in properties/proofs
};

/// The laws for which the theorems of an invariant hold.
enum class ProvedOf {
  every_impulse,  // every law, or the collision matrix, which does not depend on the law
  its_laws,       // the laws that it is claimed for and that determine one outcome
};

/// The proof that an invariant follows from the exact laws. Without theorems, an invariant is only tested, because it
/// is about a program (`finite`) or defines its law (`slip_opposed`).
struct Proof {
  ProvedOf of = ProvedOf::its_laws;
  std::vector<Theorem> theorems = {};
};

/// `Invariant::rank_as_cause` of an invariant whose violation explains no other violation.
inline constexpr int explains_none = 1000;

/// A named statement about a collision and its outcome.
struct Invariant {
  std::string_view name;
  std::string_view statement;  // one sentence
  std::string_view formula;    // LaTeX
  std::string_view source;
  std::string_view applies_to;  // the collisions that it is about
  std::vector<Law> laws;        // the laws for which it is claimed
  std::variant<AboutAnswer, AboutOutcome, AboutMatrix, AboutRelation, AboutSession> about;
  Proof proof = {};
  /// If several invariants are violated, the one with the lowest rank is the likely cause of the others.
  int rank_as_cause = explains_none;
  /// Whether the invariant applies to some collision of the kinds. nullptr: to some of any kind.
  bool (*applies_in)(const Kinds&) = nullptr;

  /// Whether the invariant is a relation.
  [[nodiscard]] bool asks() const { return std::holds_alternative<AboutRelation>(about); }

  [[nodiscard]] bool is_of_one_answer() const {
    return std::holds_alternative<AboutAnswer>(about) || std::holds_alternative<AboutOutcome>(about) || is_of_matrix();
  }

  [[nodiscard]] bool is_of_matrix() const { return std::holds_alternative<AboutMatrix>(about); }

  [[nodiscard]] bool is_of_session() const { return std::holds_alternative<AboutSession>(about); }

  [[nodiscard]] bool is_of_invalid() const;

  [[nodiscard]] bool claimed_for(Law law) const;

  [[nodiscard]] bool can_be_judged_in(const Kinds& kinds) const { return applies_in == nullptr || applies_in(kinds); }

  /// The laws for which the invariant is claimed and proved. Empty if it is only tested.
  [[nodiscard]] std::vector<Law> proved_laws() const;
};

/// A value for some invariants, in the order of the catalogue.
template <class T>
using PerInvariant = std::map<const Invariant*, T>;

[[nodiscard]] std::vector<std::string> names_of(const std::vector<const Invariant*>& invariants);

/// The catalogue, in its fixed order.
[[nodiscard]] std::span<const Invariant> all_invariants();

/// nullptr if there is none.
[[nodiscard]] const Invariant* invariant_named(std::string_view name);

}  // namespace carom::properties
