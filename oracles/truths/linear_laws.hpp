// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/truths/implicit_differentiation.hpp>
#include <carom/oracles/truths/superposition.hpp>

/// The laws whose impulse is linear in the change of relative velocity that they require.
namespace carom::oracles {

/// The law `frictionless` (eq. 18 of the note, docs/findings/note.md): F = φ N with N·K F = −(1 + ε) N·V⁻.
struct Frictionless {
  template <class T>
  [[nodiscard]] static Vector3<T> wanted_change(const Vector3<T>& n, const T& restitution,
                                                const Vector3<T>& velocity_before) {
    return change_by_restitution<T>(n, restitution, velocity_before);
  }

  /// The impulse F = φ N with N·K F = N·change. `matrix` is K, or nullptr if K is not known.
  template <class T>
  [[nodiscard]] static Vector3<T> impulse_for(const BasicCollision<T>& collision, const Vector3<T>& change,
                                              const Matrix3<T>* matrix) {
    const Vector3<T>& n = collision.normal;
    const Vector3<T> answer =
        matrix != nullptr ? Vector3<T>(*matrix * n) : relative_velocity<T>(collision, response<T>(collision, n));
    return n * T(n.dot(change) / n.dot(answer));
  }

  /// The derivatives of F = φ N with N·(K F − b) = 0, for the wanted change b: dF = φ dN + N dφ. The responses to N are
  /// computed directly, because sums over columns of matrices would cancel if a lever arm is along N.
  template <class S>
  [[nodiscard]] static Derivatives<S> derivatives(const BasicCollision<S>& c, const ImpulseDifferential<S>& of) {
    const Vector3<S>& n = c.normal;
    const S per_normal = n.dot(of.impulse) / n.dot(n);  // φ
    const Outcome<S> to_normal = response<S>(c, n);
    const Vector3<S> k_normal = relative_velocity<S>(c, to_normal);  // K N
    using Row = Eigen::Matrix<S, 1, collision_inputs>;
    Row of_condition = n.transpose() * of.left;
    of_condition.template segment<3>(of.normal) += (S(S(2) * per_normal) * k_normal - of.wanted).transpose();
    const Row d_per_normal = of_condition / S(-n.dot(k_normal));
    PerVector<Jacobian<S>> change{of.a.d_velocity + to_normal.a.velocity * d_per_normal,
                                  of.a.d_angular_velocity + to_normal.a.angular_velocity * d_per_normal,
                                  of.b.d_velocity + to_normal.b.velocity * d_per_normal,
                                  of.b.d_angular_velocity + to_normal.b.angular_velocity * d_per_normal};
    change[OutcomeVector::velocity_of_a].template middleCols<3>(of.normal) += per_normal * of.a.velocity;
    change[OutcomeVector::angular_velocity_of_a].template middleCols<3>(of.normal) +=
        per_normal * of.a.angular_velocity;
    change[OutcomeVector::velocity_of_b].template middleCols<3>(of.normal) -= per_normal * of.b.velocity;
    change[OutcomeVector::angular_velocity_of_b].template middleCols<3>(of.normal) -=
        per_normal * of.b.angular_velocity;
    Jacobian<S> impulse = n * d_per_normal;
    impulse.template middleCols<3>(of.normal) += per_normal * Matrix3<S>::Identity();
    return {impulse, change};
  }

  static constexpr bool acts_at_once = false;
};

/// The laws that determine K F.
struct SolvedByMatrix {
  template <class T>
  [[nodiscard]] static Vector3<T> impulse_for(const BasicCollision<T>& collision, const Vector3<T>& change,
                                              const Matrix3<T>* matrix) {
    return impulse_by_matrix<T>(collision, change, matrix);
  }

  template <class S>
  [[nodiscard]] static Derivatives<S> derivatives(const BasicCollision<S>& /*collision*/,
                                                  const ImpulseDifferential<S>& of) {
    return derivatives_by_matrix<S>(of);
  }
};

/// The law `reflection` (eq. 17, 20, 21 of the note, docs/findings/note.md): K F = −(1 + ε) (N·V⁻) / (N·N) N.
struct Reflection : SolvedByMatrix {
  template <class T>
  [[nodiscard]] static Vector3<T> wanted_change(const Vector3<T>& n, const T& restitution,
                                                const Vector3<T>& velocity_before) {
    return change_by_restitution<T>(n, restitution, velocity_before);
  }

  static constexpr bool acts_at_once = false;
};

/// The law `sticking`, the limit μ → ∞ of Coulomb friction: K F = −(V⁻ + ε (N·V⁻) / (N·N) N).
struct Sticking : SolvedByMatrix {
  template <class T>
  [[nodiscard]] static Vector3<T> wanted_change(const Vector3<T>& n, const T& restitution,
                                                const Vector3<T>& velocity_before) {
    const T rebound = restitution * n.dot(velocity_before);
    return -(velocity_before + n * T(rebound / n.dot(n)));
  }

  /// The impulse stops the slip for any N·V⁻ < 0.
  static constexpr bool acts_at_once = true;
};

}  // namespace carom::oracles
