// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/collision/vector.hpp>
#include <carom/oracles/motion/known.hpp>

/// The answers for bodies that fly and meet a wall, from exact inputs.
namespace carom::oracles {

/// A body that falls from rest, without spin, and bounces.
struct Fall {
  double height = 0;       // H > 0, from which it falls [m]
  double gravity = 0;      // g > 0 [m/s²]
  double restitution = 0;  // ε in [0, 1]
};

/// √(2 g H), the speed before the first impact [m/s].
[[nodiscard]] Known impact_speed(const Fall& fall);

/// ε²ⁿ H, the height that bounce n ≥ 1 reaches [m].
[[nodiscard]] Known bounce_height(const Fall& fall, unsigned n);

/// t₁ (1 + 2 (ε + … + εⁿ⁻¹)), the time of impact n ≥ 1 [s], with t₁ = √(2 H / g).
[[nodiscard]] Known impact_time(const Fall& fall, unsigned n);

/// A sphere or disc that meets a fixed wall.
struct WallImpact {
  double mass = 1;     // m > 0 [kg]
  double inertia = 1;  // J > 0, about each axis [kg m²]
  double radius = 1;   // R > 0 [m]
  double restitution = 0;
  double friction = 0;                // μ ≥ 0
  Vector3<double> normal{0, 0, 1};    // out of the wall: a unit vector without rounding
  Vector3<double> velocity{0, 0, 0};  // before the impact [m/s]; it approaches the wall
  Vector3<double> angular_velocity{0, 0, 0};
};

struct AfterImpact {
  std::array<Known, 3> velocity;
  std::array<Known, 3> angular_velocity;
  bool sticks = false;  // the contact point is at rest along the wall
};

/// The law of Coulomb at one contact. The contact point slips with V_t = (v − R w × n)_t. The impulse that stops it is
/// −V_t / λ_t, with λ_t = 1/m + R²/J. The contact sticks if this impulse is at most μ F_n, with F_n = (1 + ε) m |v_n|.
/// Otherwise the impulse is μ F_n against V_t. Throws std::bad_optional_access if rounding decides which it is.
[[nodiscard]] AfterImpact after_impact(const WallImpact& impact);

}  // namespace carom::oracles
