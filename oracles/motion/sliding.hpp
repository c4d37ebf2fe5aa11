// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/motion/known.hpp>

/// The answers for bodies that slide, roll or rest on a plane, from exact inputs.
namespace carom::oracles {

/// A body slides along a level floor from time 0 on, and does not turn. It starts with v₀ and slows down by μ g.
struct Slide {
  double speed = 0;     // v₀ > 0 [m/s]
  double friction = 0;  // μ > 0
  double gravity = 0;   // g > 0 [m/s²]
};

/// v₀ − μ g t until it stops, then 0 [m/s].
[[nodiscard]] Known slide_speed(const Slide& slide, const StepTime& time);

/// v₀ t − ½ μ g t² until it stops, then v₀² / (2 μ g) [m].
[[nodiscard]] Known slide_distance(const Slide& slide, const StepTime& time);

/// A sphere or disc starts to slide without spin, and ends up rolling. Let J = k m R².
struct SlideToRoll {
  Slide slide;
  double mass = 1;     // m > 0 [kg]
  double inertia = 1;  // J > 0, about the axis of rolling [kg m²]
  double radius = 1;   // R > 0 [m]
};

/// v₀ k / ((1 + k) μ g), at which it rolls [s].
[[nodiscard]] Known rolling_time(const SlideToRoll& roll);

/// v₀ − μ g t until it rolls, then v₀ / (1 + k) [m/s].
[[nodiscard]] Known roll_speed(const SlideToRoll& roll, const StepTime& time);

/// w R = μ g t / k until it rolls, then v₀ / (1 + k) [m/s].
[[nodiscard]] Known roll_spin(const SlideToRoll& roll, const StepTime& time);

/// The distance [m].
[[nodiscard]] Known roll_distance(const SlideToRoll& roll, const StepTime& time);

/// A body on a slope, with gravity along the slope and into it, both > 0 [m/s²]. It rests if `along` ≤ μ `into`.
/// Otherwise its acceleration is `along` − μ `into`, which is g (sin θ − μ cos θ). Throws std::bad_optional_access if
/// rounding decides which it is.
[[nodiscard]] Known slope_acceleration(double along, double into, double friction);

}  // namespace carom::oracles
