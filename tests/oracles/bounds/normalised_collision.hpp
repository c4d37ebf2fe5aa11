// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/outcome.hpp>

#include "support/rounding_count.hpp"

/// A collision for counting roundings. Masses, moments, quaternions, lever arms and the normal have lengths of at most
/// one, because relative errors do not depend on these lengths.
namespace carom::bounds {

/// The bodies are at the origin, so the lever arm r = P − X is P. P counts as rounded once, like the difference P − X.
template <class T>
[[nodiscard]] BasicCollision<T> normalised_collision() {
  BasicCollision<T> c;
  const T input(RoundingCount::input());
  for (BasicBody<T>* body : {&c.a, &c.b}) {
    body->mass = input;
    body->principal_inertia.setConstant(input);
    body->orientation.setConstant(input);
    body->velocity.setConstant(T(RoundingCount::input(0.5)));
    body->angular_velocity.setConstant(T(RoundingCount::input(0.5)));
  }
  c.point.setConstant(T(RoundingCount::input(1, 1)));
  c.normal.setConstant(input);
  c.restitution = input;
  return c;
}

}  // namespace carom::bounds
