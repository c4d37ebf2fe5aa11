// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/models/implicit_differentiation.hpp>
#include <carom/oracles/models/superposition.hpp>
#include <carom/oracles/numbers/enclosure.hpp>

namespace carom::oracles {

/// The law `sticking`, the limit μ → ∞ of Coulomb friction: K F = −(V⁻ + ε (N·V⁻) / (N·N) N).
struct Sticking {
  template <class T>
  [[nodiscard]] static Vector3<T> wanted_change(const Vector3<T>& n, const T& restitution,
                                                const Vector3<T>& velocity_before) {
    const T rebound = restitution * n.dot(velocity_before);
    return -(velocity_before + n * T(rebound / n.dot(n)));
  }

  /// `matrix` is K, or nullptr if K is not known. F causes `change` and is linear in it.
  template <class T>
  [[nodiscard]] static Vector3<T> impulse_for(const BasicCollision<T>& collision, const Vector3<T>& change,
                                              const Matrix3<T>* matrix) {
    return impulse_by_matrix<T>(collision, change, matrix);
  }

  /// `impulse` itself, because the law permits every impulse exactly (filters/refined_truth.hpp).
  [[nodiscard]] static Vector3<Enclosure> permitted(const BasicCollision<Enclosure>& /*collision*/,
                                                    const Vector3<double>& impulse) {
    return impulse.unaryExpr([](double x) { return Enclosure(x); });
  }

  /// The whole change, which the law must cause.
  [[nodiscard]] static Vector3<Enclosure> asked_for(const Vector3<Enclosure>& /*n*/, const Vector3<Enclosure>& change) {
    return change;
  }

  template <class S>
  [[nodiscard]] static Derivatives<S> derivatives(const BasicCollision<S>& /*collision*/,
                                                  const ImpulseDifferential<S>& of) {
    return derivatives_by_matrix<S>(of);
  }

  /// The equations that hold in addition to `kept_by_every_law`.
  static constexpr std::array keeps{AffineEquation::sticks};
  /// Whether the law never adds energy, apart from the work of a driven wall. If ε > 0 it may, because the tangential
  /// impulse also changes the normal velocity.
  static constexpr bool creates_no_energy = false;

  /// Whether the impulse does not tend to 0 with N·V⁻ (ExactCase::has_two_answers). The impulse stops the slip at any
  /// N·V⁻.
  static constexpr bool acts_at_once = true;
};

}  // namespace carom::oracles
