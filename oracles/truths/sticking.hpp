// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/truths/implicit_differentiation.hpp>
#include <carom/oracles/truths/superposition.hpp>

namespace carom::oracles {

/// The law `sticking`, the limit μ → ∞ of Coulomb friction: K F = −(V⁻ + ε (N·V⁻) / (N·N) N).
struct Sticking {
  template <class T>
  [[nodiscard]] static Vector3<T> wanted_change(const Vector3<T>& n, const T& restitution,
                                                const Vector3<T>& velocity_before) {
    const T rebound = restitution * n.dot(velocity_before);
    return -(velocity_before + n * T(rebound / n.dot(n)));
  }

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

  /// The impulse stops the slip for any N·V⁻ < 0.
  static constexpr bool acts_at_once = true;
};

}  // namespace carom::oracles
