// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
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
  missing,   // it solves every contact
  inverted,  // it solves the contacts that do not collide
};

/// The steps of a solver, as mistakes change them. Without a mistake, each step uses the collision as given.
struct Steps {
  Collision computed_from;  // the impulse is computed for this collision; here, ε may be any number
  Collision applied_to;     // the impulse changes the velocities of these bodies
  Law law;
  ApproachTest test = ApproachTest::right;
  bool is_each_body_alone = false;        // whether each body gets its impulse as if the other were immovable
  bool is_solved_twice = false;           // whether a second impulse follows, without a test for approach
  FrictionSteps friction = {};            // of the laws with friction
  InverseInertia inverse = nullptr;       // J⁻¹ in both steps; nullptr: as given
  double tangential = 1;                  // the factor of the impulse across the normal
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

/// A mistake in the computation of friction.
[[nodiscard]] Mistake with_friction(std::function<void(FrictionSteps&)> change);

/// Factors of the law's changes of the four velocities.
[[nodiscard]] Mistake with_factors(const PerVector<double>& factors);

/// The length ‖F‖ of all impulses [N s]. Without a value, each impulse has another length.
struct FittedLength {
  std::optional<double> value;
};

/// A possible fault of a solver: it applies the law to another collision, or misuses the right impulse.
struct Hypothesis {
  std::string as_if;    // "the lever arms of both bodies began at the world's origin"
  std::string look_at;  // the place in a solver to check
  /// A solver with this fault makes one of these mistakes. Without any, the fault changes only the size of the impulse.
  std::vector<Mistake> mistakes;
  /// The length of the impulse with this fault; empty if the mistakes alone determine it.
  std::optional<FittedLength> length = {};
  bool has_fitted_number = false;  // that the answers show
  bool needs_condition = false;    // whether other faults give its answers too, unless its cases share a condition
  bool is_choice = false;          // whether its mistakes are those of the hypotheses that precede it
};

/// All hypotheses without a fitted number. If several explain an outcome, the first one is preferred.
[[nodiscard]] std::span<const Hypothesis> all_hypotheses();

/// The outcome of a solver that makes the first mistake of the hypothesis. No value if the mistake does not apply.
/// Precondition: the hypothesis has a mistake and no fitted length.
[[nodiscard]] std::optional<Outcome<double>> answer_of(const Hypothesis& hypothesis, const KnownCase& one);

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
