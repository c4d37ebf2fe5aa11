// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <optional>
#include <variant>

#include <carom/oracles/laws/mechanics.hpp>
#include <carom/oracles/laws/truth.hpp>

/// The equations, and the set of equations that defines each law. Every verdict rests on this file. The "note" is D.
/// Eberly, "Computing Impulse Forces for Colliding Contact" (docs/findings/note.md).
namespace carom::oracles {

/// The state of the contact before the impulse. N is the normal from B to A, and V⁻ is V_A⁻ − V_B⁻ at the contact
/// point.
enum class ContactState {
  colliding,   // N·V⁻ < 0 and a body can move
  resting,     // N·V⁻ = 0
  separating,  // N·V⁻ > 0
  inert,       // both bodies immovable
};

/// The approach of a contact with a movable body, from the sign (−1, 0 or 1) of N·V⁻.
[[nodiscard]] constexpr ContactState state_of_sign(int sign) {
  if (sign < 0) {
    return ContactState::colliding;
  }
  return sign == 0 ? ContactState::resting : ContactState::separating;
}

template <class T, int N>
struct Sides {
  Eigen::Matrix<T, N, 1> left;
  Eigen::Matrix<T, N, 1> right;
};

template <class T>
using Scalar1 = Eigen::Matrix<T, 1, 1>;

/// ‖N × F‖² and (μ N·F)² for an impulse F on A.
template <class T>
[[nodiscard]] Sides<T, 1> squared_cone(const BasicCollision<T>& c, const Vector3<T>& impulse) {
  const Vector3<T> tangential = c.normal.cross(impulse);
  const T limit = c.friction * c.normal.dot(impulse);
  return {Scalar1<T>(tangential.dot(tangential)), Scalar1<T>(limit * limit)};
}

/// V⁺ − V⁻ and C F for a collision matrix C and an impulse F on A (note eq. 24).
template <class T>
[[nodiscard]] Sides<T, 3> change_by_matrix(const BasicCollision<T>& c, const Outcome<T>& after,
                                           const Matrix3<T>& matrix, const Vector3<T>& impulse) {
  return {relative_velocity<T>(c, after) - relative_velocity<T>(c, unchanged(c)), matrix * impulse};
}

/// N × F and N × V⁺.
template <class T>
struct FrictionAndSlip {
  Vector3<T> friction;
  Vector3<T> slip;
};
template <class T>
[[nodiscard]] FrictionAndSlip<T> friction_and_slip(const BasicCollision<T>& c, const Outcome<T>& after,
                                                   bool read_off_a) {
  return {c.normal.cross(impulse_on_a(c, after, read_off_a)), c.normal.cross(relative_velocity<T>(c, after))};
}

/// The equations that are affine in the outcome. For one collision, their derivatives with respect to the outcome are
/// constant.
enum class AffineEquation {
  linear_momentum,
  angular_momentum_of_a,
  angular_momentum_of_b,
  total_angular_momentum,
  restitution,
  non_penetration,
  push_read_off_a,
  push_read_off_b,
  frictionless_direction_read_off_a,
  frictionless_direction_read_off_b,
  reflection_plane,
  sticks,
  untouched_velocity_of_a,
  untouched_angular_velocity_of_a,
  untouched_velocity_of_b,
  untouched_angular_velocity_of_b,
};

/// The bound of a law's impulse (equation::ImpulseBound).
enum class ImpulseBoundOf {
  approach,                            // (1 + ε) |N·V⁻| / ‖N‖
  velocity_by_restitution,             // (1 + ε) ‖V⁻‖
  velocity_by_tangential_restitution,  // (1 + e_t) ‖V⁻‖
};

/// The bound that holds for a law at this collision. For `rough` and `any`, the larger of ε and e_t counts.
[[nodiscard]] inline ImpulseBoundOf impulse_bound_of(Law law, const Collision& c) {
  switch (law) {
    case Law::frictionless:
    case Law::reflection:
      return ImpulseBoundOf::approach;
    case Law::sticking:
    case Law::coulomb:
      return ImpulseBoundOf::velocity_by_restitution;
    case Law::rough:
    case Law::any:
      break;
  }
  return c.tangential_restitution > c.restitution ? ImpulseBoundOf::velocity_by_tangential_restitution
                                                  : ImpulseBoundOf::velocity_by_restitution;
}

/// 1 + ε, or 1 + e_t, by which the bound multiplies the velocity.
template <class T>
[[nodiscard]] T factor_of(ImpulseBoundOf bound, const BasicCollision<T>& c) {
  return T(1) +
         (bound == ImpulseBoundOf::velocity_by_tangential_restitution ? c.tangential_restitution : c.restitution);
}

/// Each struct maps (collision, outcome) to the two sides of an equation or inequality, in any field T. `name()` has a
/// value if the equation is affine in the outcome. F is computed from the velocity change of A if `read_off_a`,
/// otherwise from that of B. Precondition: this body is movable.
namespace equation {

/// m_A Δv_A = −m_B Δv_B. Precondition: both bodies are movable.
struct LinearMomentum {
  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return AffineEquation::linear_momentum; }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return {impulse_on(c.a, after.a), -impulse_on(c.b, after.b)};
  }
};

/// J Δw = r × m Δv, of A or of B. Precondition: the body is movable.
struct AngularMomentum {
  bool of_a;

  [[nodiscard]] constexpr std::optional<AffineEquation> name() const {
    return of_a ? AffineEquation::angular_momentum_of_a : AffineEquation::angular_momentum_of_b;
  }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    const BasicBody<T>& body = of_a ? c.a : c.b;
    const BodyVelocity<T>& motion = of_a ? after.a : after.b;
    return {apply_inertia<T>(body, motion.angular_velocity - body.angular_velocity),
            lever_arm(body, c.point).cross(impulse_on(body, motion))};
  }
};

/// A gains the angular momentum about the origin that B loses. Precondition: both bodies are movable.
struct TotalAngularMomentum {
  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return AffineEquation::total_angular_momentum; }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return {angular_impulse_about_origin(c.a, after.a), -angular_impulse_about_origin(c.b, after.b)};
  }
};

/// One velocity or angular velocity is unchanged.
struct Untouched {
  OutcomeVector vector;

  [[nodiscard]] constexpr std::optional<AffineEquation> name() const {
    switch (vector) {
      case OutcomeVector::velocity_of_a:
        return AffineEquation::untouched_velocity_of_a;
      case OutcomeVector::angular_velocity_of_a:
        return AffineEquation::untouched_angular_velocity_of_a;
      case OutcomeVector::velocity_of_b:
        return AffineEquation::untouched_velocity_of_b;
      case OutcomeVector::angular_velocity_of_b:
        break;
    }
    return AffineEquation::untouched_angular_velocity_of_b;
  }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    const Outcome<T> before = unchanged(c);
    return {*vectors(after)[vector], *vectors(before)[vector]};
  }
};

/// N·V⁺ = −ε N·V⁻ (note eq. 17).
struct Restitution {
  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return AffineEquation::restitution; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return {Scalar1<T>(c.normal.dot(relative_velocity<T>(c, after))),
            Scalar1<T>(-c.restitution * normal_velocity_before(c))};
  }
};

/// N·V⁺ ≥ 0.
struct NonPenetration {
  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return AffineEquation::non_penetration; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return {Scalar1<T>(c.normal.dot(relative_velocity<T>(c, after))), Scalar1<T>(T(0))};
  }
};

/// N·V⁺ ≤ |N·V⁻|: the bodies part no faster than they met.
struct PartingSpeed {
  bool collides;  // N·V⁻ < 0

  /// The derivatives with respect to the outcome are those of NonPenetration. The truth satisfies the inequality only
  /// if `collides` is right.
  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return AffineEquation::non_penetration; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    const T before = normal_velocity_before(c);
    return {Scalar1<T>(c.normal.dot(relative_velocity<T>(c, after))), Scalar1<T>(collides ? T(-before) : before)};
  }
};

/// N·F ≥ 0: contacts push.
struct Push {
  bool read_off_a;

  [[nodiscard]] constexpr std::optional<AffineEquation> name() const {
    return read_off_a ? AffineEquation::push_read_off_a : AffineEquation::push_read_off_b;
  }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return {Scalar1<T>(c.normal.dot(impulse_on_a(c, after, read_off_a))), Scalar1<T>(T(0))};
  }
};

/// N × F = 0 (note eq. 10 to 18).
struct FrictionlessDirection {
  bool read_off_a;

  [[nodiscard]] constexpr std::optional<AffineEquation> name() const {
    return read_off_a ? AffineEquation::frictionless_direction_read_off_a
                      : AffineEquation::frictionless_direction_read_off_b;
  }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return {c.normal.cross(impulse_on_a(c, after, read_off_a)), Vector3<T>{T(0), T(0), T(0)}};
  }
};

/// N × V⁺ = N × V⁻ (note eq. 20 and 21, without the note's basis).
struct ReflectionPlane {
  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return AffineEquation::reflection_plane; }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return {c.normal.cross(relative_velocity<T>(c, after)), c.normal.cross(relative_velocity<T>(c, unchanged(c)))};
  }
};

/// N × V⁺ = 0, for contacts that collide.
struct Sticks {
  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return AffineEquation::sticks; }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return {c.normal.cross(relative_velocity<T>(c, after)), Vector3<T>{T(0), T(0), T(0)}};
  }
};

/// ‖N × F‖² ≤ (μ N·F)², which is the friction cone if N·F ≥ 0.
struct FrictionCone {
  bool read_off_a;

  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return std::nullopt; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return squared_cone(c, impulse_on_a(c, after, read_off_a));
  }
};

/// (N × F) × (N × V⁺) = 0: friction is parallel to the slip after the impulse.
struct FrictionAlongSlip {
  bool read_off_a;

  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return std::nullopt; }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    const auto [friction, slip] = friction_and_slip(c, after, read_off_a);
    return {friction.cross(slip), Vector3<T>{T(0), T(0), T(0)}};
  }
};

/// (N × F)·(N × V⁺) ≤ 0: friction does not act in the direction of the slip.
struct FrictionAgainstSlip {
  bool read_off_a;

  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return std::nullopt; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    const auto [friction, slip] = friction_and_slip(c, after, read_off_a);
    return {Scalar1<T>(friction.dot(slip)), Scalar1<T>(T(0))};
  }
};

/// The squares of λ ‖F‖ ≤ (1 + ε) |N·V⁻| / ‖N‖ or of λ ‖F‖ ≤ c ‖V⁻‖, with λ = 1/m_A + 1/m_B. Every eigenvalue of the
/// collision matrix is at least λ, so a law bounds its impulse by the change of velocity that it demands.
struct ImpulseBound {
  ImpulseBoundOf of;
  bool read_off_a;

  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return std::nullopt; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    // λ m is of the order of 1, while λ² F² may leave the range of numbers.
    const BasicBody<T>& body = read_off_a ? c.a : c.b;
    const T share = inverse_mass(c) * body.mass;
    const Vector3<T> impulse = share * Vector3<T>((read_off_a ? after.a : after.b).velocity - body.velocity);
    const T factor = factor_of(of, c);
    const T squared = impulse.dot(impulse);
    if (of == ImpulseBoundOf::approach) {
      const T limit = factor * normal_velocity_before(c);
      return {Scalar1<T>(squared * c.normal.dot(c.normal)), Scalar1<T>(limit * limit)};
    }
    const Vector3<T> limit = factor * relative_velocity<T>(c, unchanged(c));
    return {Scalar1<T>(squared), Scalar1<T>(limit.dot(limit))};
  }
};

/// E⁺ − E⁻ ≤ W: the kinetic energy of the movable bodies grows by at most W, the work of a driven wall (an immovable
/// body that moves). W is the scalar product of the wall's velocity at the contact point and the impulse on the other
/// body. E⁺ − W is convex in the outcome. Precondition: a body is movable.
struct Energy {
  [[nodiscard]] static constexpr std::optional<AffineEquation> name() { return std::nullopt; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    T gain(0);
    T work(0);
    const auto wall_velocity = [&](const BasicBody<T>& body) {
      return point_velocity<T>({body.velocity, body.angular_velocity}, lever_arm(body, c.point));
    };
    if (c.a.immovable) {
      work += wall_velocity(c.a).dot(impulse_on(c.b, after.b));
    } else {
      gain += kinetic_energy_gain(c.a, after.a);
    }
    if (c.b.immovable) {
      work += wall_velocity(c.b).dot(impulse_on(c.a, after.a));
    } else {
      gain += kinetic_energy_gain(c.b, after.b);
    }
    return {Scalar1<T>(gain), Scalar1<T>(work)};
  }
};

}  // namespace equation

using Equation =
    std::variant<equation::LinearMomentum, equation::AngularMomentum, equation::TotalAngularMomentum,
                 equation::Untouched, equation::Restitution, equation::NonPenetration, equation::PartingSpeed,
                 equation::Push, equation::ImpulseBound, equation::FrictionlessDirection, equation::ReflectionPlane,
                 equation::Sticks, equation::FrictionCone, equation::FrictionAlongSlip, equation::FrictionAgainstSlip,
                 equation::Energy>;

inline constexpr std::array<Equation, 16> affine_equations{equation::LinearMomentum{},
                                                           equation::AngularMomentum{true},
                                                           equation::AngularMomentum{false},
                                                           equation::TotalAngularMomentum{},
                                                           equation::Restitution{},
                                                           equation::NonPenetration{},
                                                           equation::Push{true},
                                                           equation::Push{false},
                                                           equation::FrictionlessDirection{true},
                                                           equation::FrictionlessDirection{false},
                                                           equation::ReflectionPlane{},
                                                           equation::Sticks{},
                                                           equation::Untouched{OutcomeVector::velocity_of_a},
                                                           equation::Untouched{OutcomeVector::angular_velocity_of_a},
                                                           equation::Untouched{OutcomeVector::velocity_of_b},
                                                           equation::Untouched{OutcomeVector::angular_velocity_of_b}};

[[nodiscard]] constexpr std::optional<AffineEquation> name_of(const Equation& equation) {
  return std::visit([](const auto& one) { return one.name(); }, equation);
}

template <class T>
using PerAffineEquation = EnumArray<AffineEquation, T, affine_equations.size()>;

namespace detail {
consteval bool stand_in_the_order_of_their_names() {
  for (std::size_t i = 0; i < affine_equations.size(); ++i) {
    if (name_of(affine_equations[i]) != static_cast<AffineEquation>(i)) {
      return false;
    }
  }
  return true;
}
}  // namespace detail
static_assert(detail::stand_in_the_order_of_their_names());

/// Calls visit(name, equation) for each equation that defines the answer of a law to a contact with this approach. The
/// law `rough` has further conditions, which `first_refuted_of_rough` checks. Precondition: the law is one of
/// `laws_with_truth`.
template <class T, class Visit>
void for_each_defining_equation(const BasicCollision<T>& c, Law law, ContactState approach, const Visit& visit) {
  const auto visit_untouched = [&](const char* name, bool a) {
    for (const OutcomeVector vector : vectors_of_body(a)) {
      visit(name, equation::Untouched{vector});
    }
  };
  if (approach != ContactState::colliding) {
    visit_untouched("the velocities of A being untouched", true);
    visit_untouched("the velocities of B being untouched", false);
    return;
  }
  if (c.a.immovable) {
    visit_untouched("the immovable A being untouched", true);
  } else {
    visit("the angular momentum of A", equation::AngularMomentum{true});
  }
  if (c.b.immovable) {
    visit_untouched("the immovable B being untouched", false);
  } else {
    visit("the angular momentum of B", equation::AngularMomentum{false});
  }
  if (!c.a.immovable && !c.b.immovable) {
    visit("linear momentum", equation::LinearMomentum{});
  }
  switch (law) {
    case Law::frictionless:
      visit("restitution", equation::Restitution{});
      visit("the frictionless direction", equation::FrictionlessDirection{reads_impulse_off_a(c)});
      return;
    case Law::reflection:
      visit("restitution", equation::Restitution{});
      visit("the reflection plane", equation::ReflectionPlane{});
      return;
    case Law::sticking:
      visit("restitution", equation::Restitution{});
      visit("sticking", equation::Sticks{});
      return;
    case Law::rough:  // first_refuted_of_rough checks the rest, which is no equation of the outcome alone
      visit("restitution", equation::Restitution{});
      return;
    case Law::coulomb:
    case Law::any:
      break;
  }
  determines_no_outcome(law);
}

}  // namespace carom::oracles
