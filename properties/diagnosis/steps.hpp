// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>

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

}  // namespace carom::properties::diagnosis
