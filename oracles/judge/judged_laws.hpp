// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include <carom/oracles/laws/equations.hpp>

namespace carom::oracles {

/// The laws that are affine in the outcome: their derivatives by it are one and the same for all outcomes of a case.
enum class AffineLaw {
  linear_momentum,
  angular_momentum_of_a,
  angular_momentum_of_b,
  total_angular_momentum,
  restitution,
  non_penetration,
  push,
  frictionless_direction,
  reflection_plane,
  untouched_a,
  untouched_b,
};
inline constexpr std::size_t affine_law_count = 11;

/// The laws of laws.hpp as objects, (collision, outcome) → Sides in any field, for the judge. Each knows its name among
/// the affine ones. Preconditions as there.
namespace law {

/// m_A Δv_A = −m_B Δv_B.
struct LinearMomentum {
  [[nodiscard]] static std::optional<AffineLaw> name() { return AffineLaw::linear_momentum; }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return linear_momentum(c, after);
  }
};

/// J Δw = r × m Δv, of A or of B.
struct AngularMomentum {
  bool of_a;

  [[nodiscard]] std::optional<AffineLaw> name() const {
    return of_a ? AffineLaw::angular_momentum_of_a : AffineLaw::angular_momentum_of_b;
  }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return of_a ? angular_momentum(c.a, c.point, after.a) : angular_momentum(c.b, c.point, after.b);
  }
};

/// What A gains about the origin, B loses.
struct TotalAngularMomentum {
  [[nodiscard]] static std::optional<AffineLaw> name() { return AffineLaw::total_angular_momentum; }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return total_angular_momentum(c, after);
  }
};

/// The velocities of A or of B are as before.
struct Untouched {
  bool a;

  [[nodiscard]] std::optional<AffineLaw> name() const { return a ? AffineLaw::untouched_a : AffineLaw::untouched_b; }

  template <class T>
  [[nodiscard]] Sides<T, 6> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return a ? untouched(c.a, after.a) : untouched(c.b, after.b);
  }
};

/// N·V⁺ = −ε N·V⁻.
struct Restitution {
  [[nodiscard]] static std::optional<AffineLaw> name() { return AffineLaw::restitution; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return restitution(c, after);
  }
};

/// N·V⁺ ≥ 0.
struct NonPenetration {
  [[nodiscard]] static std::optional<AffineLaw> name() { return AffineLaw::non_penetration; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return non_penetration(c, after);
  }
};

/// N·F ≥ 0, F read off A or off B.
struct Push {
  bool read_off_a;

  [[nodiscard]] std::optional<AffineLaw> name() const { return AffineLaw::push; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return push(c, after, read_off_a);
  }
};

/// N × F = 0, F read off A or off B.
struct FrictionlessDirection {
  bool read_off_a;

  [[nodiscard]] std::optional<AffineLaw> name() const { return AffineLaw::frictionless_direction; }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return frictionless_direction(c, after, read_off_a);
  }
};

/// N × V⁺ = N × V⁻.
struct ReflectionPlane {
  [[nodiscard]] static std::optional<AffineLaw> name() { return AffineLaw::reflection_plane; }

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return reflection_plane(c, after);
  }
};

/// E⁺ − E⁻ ≤ W; not affine, but convex in the outcome.
struct Energy {
  [[nodiscard]] static std::optional<AffineLaw> name() { return std::nullopt; }

  template <class T>
  [[nodiscard]] Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return energy(c, after);
  }
};

}  // namespace law
}  // namespace carom::oracles
