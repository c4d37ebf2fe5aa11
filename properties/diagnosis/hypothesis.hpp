// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <carom/properties/diagnosis/known_case.hpp>

namespace carom::properties::diagnosis {

/// How a solver decides whether it solves a contact.
enum class ApproachTest {
  right,
  missing,   // it solves every contact
  inverted,  // it solves the contacts that do not collide
};

/// The steps of a solver, as mistakes change them. Without a mistake, each step uses the collision as given.
struct Steps {
  Collision computed_from;  // the impulse is computed for this collision
  Collision applied_to;     // the impulse changes the velocities of these bodies
  Law law;
  ApproachTest test = ApproachTest::right;
  bool is_each_body_alone = false;        // whether each body gets its impulse as if the other were immovable
  PerVector<double> factors{1, 1, 1, 1};  // of the changes of the outcome vectors
  bool has_right_impulse = true;          // whether no mistake changes the computation of the impulse
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

/// A mistake in the collision that both steps use.
[[nodiscard]] Mistake misread_as(std::function<void(Collision&)> change);

/// A mistake in the computation of the impulse alone. The impulse is applied to the right bodies.
[[nodiscard]] Mistake computed_as(std::function<void(Collision&)> change);

/// A mistake in the application of the impulse alone. The impulse itself is right.
[[nodiscard]] Mistake applied_as(std::function<void(Collision&)> change);

/// A quantity that a solver may replace by a constant, and that an answer shows.
enum class Fit {
  added_restitution,  // the number that is added to ε
  length_of_impulse,  // ‖F‖ [N s]
};

/// A fit, and its value in a solver. Without a value, the solver uses a new one for each collision.
struct FittedSize {
  Fit fit;
  std::optional<double> value;
};

/// The value with which the steps give the subject's answer, within a thousandth of the subject's error. No value if
/// there is none.
[[nodiscard]] std::optional<double> fitted(Fit fit, const Steps& steps, const KnownCase& one);

/// Whether the steps with this size give the subject's answer, within a thousandth of the subject's error.
[[nodiscard]] bool gives_answer(const FittedSize& size, const Steps& steps, const KnownCase& one);

/// Whether two fitted values are equal within a thousandth.
[[nodiscard]] bool agree(double x, double y);

/// A possible fault of a solver: it applies the law to another collision, or misuses the right impulse.
struct Hypothesis {
  std::string as_if;    // "the lever arms of both bodies began at the world's origin"
  std::string look_at;  // the place in a solver to check
  /// A solver with this fault makes one of these mistakes. Without any, the fault changes only the size of the impulse.
  std::vector<Mistake> mistakes;
  /// The size of the impulse with this fault; empty if the mistakes alone determine it.
  std::optional<FittedSize> size = {};
};

/// All hypotheses without a fitted size. If several explain an outcome, the first one is preferred.
[[nodiscard]] std::span<const Hypothesis> all_hypotheses();

/// The outcome of a solver that makes the first mistake of the hypothesis. No value if the mistake does not apply.
/// Precondition: the hypothesis has a mistake and no fitted size.
[[nodiscard]] std::optional<Outcome<double>> answer_of(const Hypothesis& hypothesis, const KnownCase& one);

/// Whether the hypotheses together give the subject's answer, within a thousandth of the subject's error. A solver with
/// several faults makes a mistake of each.
[[nodiscard]] bool explains(std::span<const Hypothesis* const> together, const KnownCase& one);
[[nodiscard]] bool explains(const Hypothesis& hypothesis, const KnownCase& one);

// The groups of the hypotheses, one file each.
[[nodiscard]] std::vector<Hypothesis> misused_impulses();
[[nodiscard]] std::vector<Hypothesis> misread_contacts();
[[nodiscard]] std::vector<Hypothesis> misread_bodies();

}  // namespace carom::properties::diagnosis
