// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/outcome.hpp>

/// A solver with a defect that the property in README.md finds. The solver tests for approach with the velocities of
/// the centres, and ignores rotation.
inline carom::Outcome<double> my_solver(const carom::Collision& c) {
  carom::Outcome<double> after = carom::unchanged(c);
  const double of_a = c.a.immovable ? 0 : 1 / c.a.mass;
  const double of_b = c.b.immovable ? 0 : 1 / c.b.mass;
  const double approach = c.normal.dot(c.a.velocity - c.b.velocity);
  if (approach < 0 && of_a + of_b > 0) {
    const double j = -(1 + c.restitution) * approach / (c.normal.squaredNorm() * (of_a + of_b));
    after.a.velocity += c.normal * (j * of_a);
    after.b.velocity -= c.normal * (j * of_b);
  }
  return after;
}
