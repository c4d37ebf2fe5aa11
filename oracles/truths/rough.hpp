// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/oracles/laws/rough.hpp>
#include <carom/oracles/laws/truth.hpp>
#include <carom/oracles/truths/linear_laws.hpp>

namespace carom::oracles {

/// The law `rough` (A. Chatterjee, A. Ruina 1998): F = (1 + ε) P_I + κ D with D = P_II − P_I. P_I stops the approach
/// (`Frictionless` with ε = 0), and P_II stops the contact point (`Sticking` with ε = 0). κ, the share of friction, is
/// 1 + e_t if this share puts F into the friction cone. Otherwise κ puts F on the cone's surface.
struct Rough {
  using StopsApproach = Frictionless;
  using StopsPoint = Sticking;

  /// F with κ = 1 + e_t lies in the cone if neither member is negative.
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

  /// Some κ > 0 puts F on the cone's surface if `along_normal` < 0 or `beyond` > 0.
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

  /// The divisor ‖N × D‖ − μ N·D in the formula of κ on the cone's surface.
  template <class T>
  [[nodiscard]] static T divisor(const BasicCollision<T>& c, const Vector3<T>& d) {
    const Vector3<T> tangential = c.normal.cross(d);
    using std::sqrt;
    return sqrt(T(tangential.dot(tangential))) - c.friction * c.normal.dot(d);
  }

  /// κ on this branch. Without friction, κ is 0.
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

  /// (1 + ε) P_I + κ D, for the impulses P_I and D or for the velocity changes that they cause. `share` is κ.
  template <class T>
  [[nodiscard]] static Vector3<T> combined(const BasicCollision<T>& c, const Vector3<T>& stops_approach,
                                           const Vector3<T>& d, const T& share) {
    return Vector3<T>(stops_approach * T(T(1) + c.restitution)) + Vector3<T>(d * share);
  }

  /// Inside the cone, the impulse tends to κ D as N·V⁻ tends to 0. κ D lies in the cone for large μ.
  static constexpr bool acts_at_once = true;
};

}  // namespace carom::oracles
