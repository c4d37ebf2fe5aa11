// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/models/implicit_differentiation.hpp>
#include <carom/oracles/models/superposition.hpp>
#include <carom/oracles/numbers/enclosure.hpp>

namespace carom::oracles {

/// The law `reflection` (note eq. 17, 20, 21): K F = −(1 + ε) (N·V⁻) / (N·N) N.
struct Reflection {
  // How its truth is found: F brings about the wanted change of relative velocity, and is linear in it.

  template <class T>
  [[nodiscard]] static Vector3<T> wanted_change(const Vector3<T>& n, const T& restitution,
                                                const Vector3<T>& velocity_before) {
    return change_by_restitution<T>(n, restitution, velocity_before);
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
  static constexpr std::array keeps{AffineEquation::push_read_off_a, AffineEquation::push_read_off_b,
                                    AffineEquation::reflection_plane};
  /// Whether its answer never has more energy than before, beside the work of a driven wall.
  static constexpr bool creates_no_energy = false;

  // What happens where the contact only just collides.

  /// Whether the impulse does not vanish with N·V⁻.
  static constexpr bool acts_at_once = false;
};

}  // namespace carom::oracles
