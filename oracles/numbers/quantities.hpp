// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/oracles/numbers/norm.hpp>

/// The quantities of a collision. Each of them is perturbed as a whole, by ulps of its length and in any direction, so
/// that what is allowed does not depend on the axes of the world.
namespace carom::oracles {

/// A scalar or a vector among the numbers of a collision, in the order of `for_each_number`. Scalars are the mass, each
/// principal moment, ε, μ and e_t; vectors are positions, velocities, the contact point, the normal and orientations.
struct Quantity {
  std::size_t first;  // of its numbers
  std::size_t count;  // 1, 3 or 4
  double length;      // its absolute value or Euclidean norm; for a position of a movable body ‖X‖ + s
};

/// The extent s of a body [m]: s² = min_i (J_j + J_k − J_i) / (2m), the least of its second moments about its principal
/// planes, so that a needle has its thickness; 0 where that is negative, and of an immovable body. A point of a body is
/// known to no better than rounding of the body's size, wherever the origin is.
[[nodiscard]] double extent_of(const Body& body);

/// The length by which the position of a body is perturbed: ‖X‖ + s.
[[nodiscard]] inline double length_of_position(const Body& body) { return norm_of(body.position) + extent_of(body); }

[[nodiscard]] std::vector<Quantity> quantities_of(const Collision& collision);

/// Σ_q ‖∂y/∂q‖ ‖q‖ over the quantities q, with Frobenius norms. `derivative(i, j)` is that of component i of y, of
/// `components`, by number j. A quantity that is zero has no part, however steep y is there.
template <class Derivative>
[[nodiscard]] auto sum_over_quantities(const std::vector<Quantity>& quantities, std::size_t components,
                                       const Derivative& derivative) {
  using S = decltype(derivative(std::size_t{0}, std::size_t{0}));
  S sum(0);
  for (const Quantity& q : quantities) {
    if (q.length != 0) {
      const S norm = root_of_squares(
          components * q.count, [&](std::size_t i) -> S { return derivative(i / q.count, q.first + i % q.count); });
      sum += norm * static_cast<S>(q.length);
    }
  }
  return sum;
}

}  // namespace carom::oracles
