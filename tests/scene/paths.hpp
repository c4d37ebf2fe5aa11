// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/arc.hpp>

#include "support/exact.hpp"

namespace carom::unit {

using Vector = Vector3<double>;

[[nodiscard]] inline scene::Path path_of(const Vector& position, const Vector& velocity, const Vector& acceleration,
                                         double radius, double start = 0) {
  scene::Path path;
  path.start = start;
  path.position = position;
  path.velocity = velocity;
  path.acceleration = acceleration;
  path.radius = radius;
  measure(path);
  return path;
}

[[nodiscard]] inline scene::Path resting(const Vector& position, double radius) {
  return path_of(position, Vector::Zero(), Vector::Zero(), radius);
}

[[nodiscard]] inline ExactVector exact_position(const scene::Path& path, double time) {
  const Rational s = Rational(time) - Rational(path.start);
  ExactVector result;
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = Rational(path.position[axis]) +
                   s * (Rational(path.velocity[axis]) + s * Rational(path.acceleration[axis]) / Rational(2));
  }
  return result;
}

}  // namespace carom::unit
