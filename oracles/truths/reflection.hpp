// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/truths/implicit_differentiation.hpp>
#include <carom/oracles/truths/superposition.hpp>

namespace carom::oracles {

/// The law `reflection` (eq. 17, 20, 21 of the note, docs/findings/note.md): K F = −(1 + ε) (N·V⁻) / (N·N) N.
struct Reflection {
  template <class T>
  [[nodiscard]] static Vector3<T> wanted_change(const Vector3<T>& n, const T& restitution,
                                                const Vector3<T>& velocity_before) {
    return change_by_restitution<T>(n, restitution, velocity_before);
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

  static constexpr bool acts_at_once = false;
};

}  // namespace carom::oracles
