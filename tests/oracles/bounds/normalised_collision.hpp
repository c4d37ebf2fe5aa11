// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/outcome.hpp>

#include "support/rounding_count.hpp"

/// A collision to count roundings over: masses, moments, quaternions, lever arms and the normal of length one at most,
/// which no law's relative error depends on.
namespace carom::bounds {

/// T(x) for each number x. The bodies stand at the origin, so that P is the lever arm r = P − X with its one rounding,
/// whatever P and X cancel.
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
