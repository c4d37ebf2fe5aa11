// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <carom/properties/diagnosis/friction.hpp>
#include <carom/properties/diagnosis/known_case.hpp>

namespace carom::properties::diagnosis {

/// How a solver decides whether it solves a contact.
enum class ApproachTest {
  right,
  missing,     // it solves every contact
  inverted,    // it solves the contacts that do not collide
  of_centres,  // it tests the velocities of the centres alone
};

/// The part of an impulse that is not computed, but read off the subject's answer.
enum class Freedom { none, length, whole };

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The steps of a solver, as mistakes change them. Without a mistake, each step uses the collision as given.
struct Steps {
  Collision computed_from;  // the impulse is computed for this collision; here, ε may be any number
  Collision applied_to;     // the impulse changes the velocities of these bodies
  Law law;
  ApproachTest test = ApproachTest::right;
  bool is_each_body_alone = false;  // whether each body gets its impulse as if the other were immovable
  bool is_solved_twice = false;     // whether a second impulse follows, without a test for approach
  Freedom freedom = Freedom::none;  // of the impulse
  FrictionSteps friction = {};      // of the laws with friction
  MatrixSteps matrix = {};
  double normal = 1;                    // the factor of the impulse along the normal
  double tangential = 1;                // the factor of the impulse across the normal
  Vector3<double> components{1, 1, 1};  // factors of the impulse's components
  double most_impulse = unlimited;      // [N s]
  bool has_turned_torque_of_a = false;  // whether A's spin is changed by r × (Rᵀ F)
  bool has_turned_torque_of_b = false;
  PerVector<double> factors{1, 1, 1, 1};   // of the changes of the outcome vectors
  double most_speed = unlimited;           // of the outcome [m/s]
  double most_spin = unlimited;            // of the outcome [rad/s]
  bool has_right_impulse = true;           // whether no mistake changes the computation of the impulse
  Effort effort = Effort::rational;        // of the law's answers
  const SlowImpulses* impulses = nullptr;  // KnownCase::impulses
};

/// Changes the steps as a mistake would. Returns false if the mistake does not apply to the case.
using Mistake = std::function<bool(Steps&, const KnownCase&)>;

[[nodiscard]] Steps right_steps(const KnownCase& one);

/// The impulses on A and on B that the steps compute. No value if they use an invalid collision.
struct Impulses {
  Vector3<double> on_a;
  Vector3<double> on_b;
};
[[nodiscard]] std::optional<Impulses> impulses_by(const Steps& steps, const KnownCase& one);

/// The velocities of the case, and the changes by the impulses.
[[nodiscard]] Outcome<double> outcome_by(const Steps& steps, const Impulses& impulses, const KnownCase& one);

/// The use of a collision that a solver misreads.
enum class Use {
  everywhere,
  computation,  // of the impulse, which is applied to the right bodies
  velocity,     // V⁻
  matrix,       // K
  application,  // of the impulse, which itself is right
};

/// " in the collision matrix"; empty for `everywhere`.
[[nodiscard]] const char* words_of(Use use);

/// A mistake in the collision that the solver uses there.
[[nodiscard]] Mistake misread_in(Use use, std::function<void(Collision&)> change);
[[nodiscard]] Mistake misread_as(std::function<void(Collision&)> change);   // everywhere
[[nodiscard]] Mistake computed_as(std::function<void(Collision&)> change);  // in the computation

/// A mistake in other steps of a case. It applies to every case.
[[nodiscard]] Mistake with_steps(std::function<void(Steps&, const KnownCase&)> change);

/// A mistake in the computation of friction.
[[nodiscard]] Mistake with_friction(std::function<void(FrictionSteps&)> change);

/// Factors of the law's changes of the four velocities.
[[nodiscard]] Mistake with_factors(const PerVector<double>& factors);

/// A possible fault of a solver: it applies the law to another collision, or misuses the right impulse.
struct Hypothesis {
  std::string as_if;                // "the lever arms of both bodies began at the world's origin"
  std::string look_at;              // the place in a solver to check
  std::vector<Mistake> mistakes;    // a solver with this fault makes one of them
  bool changes_application = true;  // whether the application of the impulse may be wrong
  bool has_fitted_number = false;   // that the answers show
  bool is_limit = false;            // whether a right answer beyond the fitted number refutes it
  bool needs_condition = false;     // whether other faults give its answers too, unless its cases share a condition
  bool is_choice = false;           // whether its mistakes are those of the hypotheses that precede it
};

/// All hypotheses without a fitted number. If several explain an outcome, the first one is preferred.
[[nodiscard]] std::span<const Hypothesis> all_hypotheses();

/// The outcome of a solver that makes the first mistake of the hypothesis. No value if the mistake does not apply.
/// Precondition: the hypothesis has a mistake.
[[nodiscard]] std::optional<Outcome<double>> answer_of(const Hypothesis& hypothesis, const KnownCase& one);

/// The outcome of these steps. No value if they use an invalid collision, or if the law has no answer.
[[nodiscard]] std::optional<Outcome<double>> outcome_of(const Steps& steps, const KnownCase& one);

/// Whether some impulse gives the subject's answer, so that only the computation of the impulse may be wrong.
[[nodiscard]] bool is_applied_right(const KnownCase& one);

/// Whether the hypotheses together give the subject's answer (`is_explained_by`). A solver with several faults makes a
/// mistake of each.
[[nodiscard]] bool explains(std::span<const Hypothesis* const> together, const KnownCase& one);
[[nodiscard]] bool explains(const Hypothesis& hypothesis, const KnownCase& one);

// The groups of the hypotheses, one file each.
[[nodiscard]] std::vector<Hypothesis> misused_impulses();
[[nodiscard]] std::vector<Hypothesis> misread_contacts();
[[nodiscard]] std::vector<Hypothesis> misread_friction();
[[nodiscard]] std::vector<Hypothesis> misread_bodies();

}  // namespace carom::properties::diagnosis
