// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include <carom/oracles/bounds/lazy.hpp>
#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties::diagnosis {

/// A law's answer in binary64, within one or two roundings.
struct LawAnswer {
  Outcome<double> outcome;
  Vector3<double> impulse;  // on A
};

/// Whether the impulse is linear in the velocities. The formula of such a law also extends to contacts that do not
/// collide.
[[nodiscard]] bool is_linear(Law law);

/// The law's answer to a collision. If set, `approach` replaces the approach of the collision. Preconditions: the
/// collision is valid; the law determines an outcome; a contact that does not collide is solved only by a linear law.
[[nodiscard]] LawAnswer law_answer(const Collision& collision, Law law,
                                   std::optional<oracles::ContactState> approach = {});

/// `ExactCase::state`, in less time where the sign of N·V⁻ is clear.
[[nodiscard]] oracles::ContactState state_of(const Collision& collision);

/// How long the computation of an answer may take: milliseconds with rational numbers, microseconds without them.
enum class Effort { rational, without_rationals };

/// The law and the collision whose impulse is asked for.
struct LawQuestion {
  Collision collision;
  Law law;
  oracles::ContactState approach;

  [[nodiscard]] bool operator==(const LawQuestion& other) const;
};

/// Impulses that need bounds or rational numbers. Many hypotheses ask the same question.
using SlowImpulses = oracles::LazyMap<LawQuestion, Vector3<double>>;

/// The impulse of `law_answer`, with a relative error below 2⁻³⁴. It takes less time. There is no value if `coulomb`
/// has several answers, or if the answer cannot be computed so well with this effort. `known`, if set, keeps what needs
/// bounds or rational numbers.
[[nodiscard]] std::optional<Vector3<double>> law_impulse(const Collision& collision, Law law,
                                                         std::optional<oracles::ContactState> approach = {},
                                                         Effort effort = Effort::rational,
                                                         const SlowImpulses* known = nullptr);

/// A case that the subject answered by an outcome, and the law's answer.
struct KnownCase {
  Collision collision;
  Law law = Law::any;
  oracles::ContactState approach = oracles::ContactState::inert;
  Outcome<double> before;
  Outcome<double> answered;
  Outcome<double> truth;    // nearest binary64 numbers
  Vector3<double> impulse;  // of the law, on A
  /// An outcome at a larger energy distance from the subject's does not explain it.
  double most_distant = std::numeric_limits<double>::infinity();
  double near = 0;                       // an outcome at this energy distance explains it; of answers with few digits
  std::optional<double> tolerance = {};  // the energy distance at which an outcome explains it, if it is known
  /// The impulses of the collisions that mistakes make of this one. Copies share this map. Use all copies in
  /// one thread.
  std::shared_ptr<const SlowImpulses> impulses = std::make_shared<const SlowImpulses>();
};

/// No value if the collision is invalid, if the answer is not an outcome of finite numbers, or if the law determines no
/// outcome of this collision.
[[nodiscard]] std::optional<KnownCase> known_case(const ViolatedCase& violated, Law law);

/// The case of a valid collision, with the subject's outcome. No value if the law determines no outcome of it.
[[nodiscard]] std::optional<KnownCase> known_case(const Collision& collision, const Outcome<double>& answered, Law law);

/// Σ m x_v·y_v + x_w·J y_w over the movable bodies, for two changes of the velocities.
[[nodiscard]] double energy_product(const Collision& collision, const Outcome<double>& x, const Outcome<double>& y);

/// √(Σ m ‖δv‖² + δwᵀ J δw) over the movable bodies, with the differences δv and δw of the velocities. It makes
/// velocities and angular velocities comparable.
[[nodiscard]] double energy_distance(const Collision& collision, const Outcome<double>& x, const Outcome<double>& y);

/// Whether the outcome is near the subject's: within a thousandth of the subject's error and `most_distant`, or within
/// `near`. An immovable body must have the same velocities.
[[nodiscard]] bool is_explained_by(const Outcome<double>& outcome, const KnownCase& one);

/// The energy distance at which an outcome explains the subject's answer.
[[nodiscard]] double tolerance_of(const KnownCase& one);

/// Whether the outcome is so far off that rounding with this unit roundoff cannot be the cause.
[[nodiscard]] bool is_visibly_off(const KnownCase& one, double unit_roundoff);

/// The energy distance that rounding with this unit roundoff causes, amplified as the case amplifies: by lever arms
/// that are differences of large positions, and by the collision matrix.
[[nodiscard]] double rounding_distance(const KnownCase& one, double unit_roundoff);

/// The velocities after the impulse F on A and −F on B: v ± F/m, w ± J⁻¹(r × F) for movable bodies.
[[nodiscard]] Outcome<double> pushed(const Collision& collision, const Vector3<double>& impulse);

/// The case that the judge compares with the law, and the answer without the effects that the subject declares
/// (declared_effects.hpp), rounded to binary64. An invalid case stays as it is.
[[nodiscard]] ViolatedCase without_effects(const ViolatedCase& one, const Subject& subject);

}  // namespace carom::properties::diagnosis
