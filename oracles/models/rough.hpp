// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>

#include <carom/oracles/laws/branch.hpp>
#include <carom/oracles/laws/rough.hpp>
#include <carom/oracles/models/frictionless.hpp>
#include <carom/oracles/models/sticking.hpp>

namespace carom::oracles {

/// The law `rough` (A. Chatterjee, A. Ruina 1998): F = (1 + ε) P_I + κ D with D = P_II − P_I. P_I stops the approach,
/// P_II the contact point; κ = 1 + e_t where that F lies in the friction cone, else what puts F on its surface. It is
/// linear in P_I and P_II but for κ, and these are the impulses of two linear laws without restitution.
struct Rough {
  using StopsApproach = Frictionless;
  using StopsPoint = Sticking;

  /// Of what decides whether F with κ = 1 + e_t lies in the cone: where neither is negative.
  template <class T>
  struct Whole {
    T along_normal;  // N·F
    T slack;         // (μ N·F)² − ‖N × F‖²
  };
  template <class T>
  [[nodiscard]] static Whole<T> whole(const BasicCollision<T>& c, const Vector3<T>& stops_approach,
                                      const Vector3<T>& d) {
    const Vector3<T> f = combined(c, stops_approach, d, T(T(1) + c.tangential_restitution));
    const Sides<T, 1> cone = squared_cone(c, f);
    return {c.normal.dot(f), cone.right[0] - cone.left[0]};
  }

  /// Of what decides whether some κ > 0 puts F on the surface: none does where N·D ≥ 0 and the other is not positive.
  template <class T>
  struct Reach {
    T along_normal;  // N·D
    T beyond;        // ‖N × D‖² − (μ N·D)²
  };
  template <class T>
  [[nodiscard]] static Reach<T> reach(const BasicCollision<T>& c, const Vector3<T>& d) {
    const Sides<T, 1> cone = squared_cone(c, d);
    return {c.normal.dot(d), cone.left[0] - cone.right[0]};
  }

  /// ‖N × D‖ − μ N·D, by which κ is divided on the cone's surface.
  template <class T>
  [[nodiscard]] static T divisor(const BasicCollision<T>& c, const Vector3<T>& d) {
    const Vector3<T> tangential = c.normal.cross(d);
    using std::sqrt;
    return sqrt(T(tangential.dot(tangential))) - c.friction * c.normal.dot(d);
  }

  /// κ; without μ friction does nothing.
  template <class T>
  [[nodiscard]] static T friction_share(const BasicCollision<T>& c, const Vector3<T>& stops_approach,
                                        const Vector3<T>& d, Branch branch) {
    if (branch == Branch::only) {
      return T(0);
    }
    if (branch == Branch::inside_cone) {
      return T(1) + c.tangential_restitution;
    }
    return c.friction * (T(1) + c.restitution) * c.normal.dot(stops_approach) / divisor(c, d);
  }

  /// (1 + ε) P_I + κ D, of impulses and of what they change alike.
  template <class T>
  [[nodiscard]] static Vector3<T> combined(const BasicCollision<T>& c, const Vector3<T>& stops_approach,
                                           const Vector3<T>& d, const T& share) {
    return Vector3<T>(stops_approach * T(T(1) + c.restitution)) + Vector3<T>(d * share);
  }

  // What its closeness rests on.

  /// The equations, beside those of every law, that its answer satisfies to every contact that they speak of.
  static constexpr std::array keeps{AffineEquation::push_read_off_a, AffineEquation::push_read_off_b};
  /// Whether its answer never has more energy than before, beside the work of a driven wall: P_I and D are
  /// K-orthogonal, so ΔE = −½ (1 − ε²) P_IᵀK P_I − ½ κ (2 − κ) DᵀK D, and 0 ≤ κ ≤ 2.
  static constexpr bool creates_no_energy = true;

  // What happens where the contact only just collides.

  /// Whether the impulse does not vanish with N·V⁻ inside the cone: it does not where D itself lies in it, for great
  /// friction.
  static constexpr bool acts_at_once = true;
};

}  // namespace carom::oracles
