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
  // How its truth is found: F brings about the wanted change of relative velocity, and is linear in it.

  template <class T>
  [[nodiscard]] static Vector3<T> wanted_change(const Vector3<T>& n, const T& restitution,
                                                const Vector3<T>& velocity_before) {
    const T rebound = restitution * n.dot(velocity_before);
    return -(velocity_before + n * T(rebound / n.dot(n)));
  }

  /// `matrix` is the response matrix where it is known already.
  template <class T>
  [[nodiscard]] static Vector3<T> impulse_for(const BasicCollision<T>& collision, const Vector3<T>& change,
                                              const Matrix3<T>* matrix) {
    return impulse_by_matrix<T>(collision, change, matrix);
  }

  // Its refinement.

  /// An impulse that the law permits, exactly, next to this one.
  [[nodiscard]] static Vector3<Enclosure> permitted(const BasicCollision<Enclosure>& /*collision*/,
                                                    const Vector3<double>& impulse) {
    return impulse.unaryExpr([](double x) { return Enclosure(x); });
  }

  /// What of a change of relative velocity the law asks for.
  [[nodiscard]] static Vector3<Enclosure> asked_for(const Vector3<Enclosure>& /*n*/, const Vector3<Enclosure>& change) {
    return change;
  }

  // Its sensitivity.

  template <class S>
  [[nodiscard]] static Derivatives<S> derivatives(const BasicCollision<S>& /*collision*/,
                                                  const ImpulseDifferential<S>& of) {
    return derivatives_by_matrix<S>(of);
  }

  // What its closeness rests on.

  /// The equations, beside those of every law, that its answer satisfies to every contact that they speak of.
  static constexpr std::array keeps{AffineEquation::sticks};
  /// Whether its answer never has more energy than before, beside the work of a driven wall. It does for ε > 0, where
  /// what the tangential impulse does along the normal speeds the bodies up.
  static constexpr bool creates_no_energy = false;

  // What happens where the contact only just collides.

  /// Whether the impulse does not vanish with N·V⁻: it stops the slip, however slow the approach.
  static constexpr bool acts_at_once = true;
};

}  // namespace carom::oracles
