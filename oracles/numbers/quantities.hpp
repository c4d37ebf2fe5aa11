// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/oracles/numbers/norm.hpp>

/// The quantities of a collision. The backward error perturbs each quantity as a whole, by ulps of its length and in
/// any direction. So the allowance does not depend on the axes of the world.
namespace carom::oracles {

/// A scalar or a vector among the numbers of a collision, in the order of `for_each_number`. The scalars are the mass,
/// each principal moment, ε, μ and e_t. The vectors are the positions, the velocities, the contact point, the normal
/// and the orientations.
struct Quantity {
  std::size_t first;  // index of its first number
  std::size_t count;  // number of its components: 1, 3 or 4
  double length;      // its absolute value or Euclidean norm; ‖X‖ + s for the position of a movable body
};

/// The extent s of a body [m]: s² = min_i (J_j + J_k − J_i) / (2m), with the principal moments J. This is the least of
/// the body's second moments about its principal planes, so the extent of a needle is its thickness. The extent is 0 if
/// the minimum is negative, and 0 for an immovable body. A point of a body is known only to within the rounding of the
/// body's size, for any origin.
[[nodiscard]] double extent_of(const Body& body);

/// The length by which the position of a body is perturbed: ‖X‖ + s.
[[nodiscard]] inline double length_of_position(const Body& body) { return norm_of(body.position) + extent_of(body); }

[[nodiscard]] std::vector<Quantity> quantities_of(const Collision& collision);

/// Σ_q ‖∂y/∂q‖ ‖q‖ over the quantities q, with Frobenius norms. `derivative(i, j)` is the derivative of component i of
/// y with respect to number j. y has `components` components. A quantity that is zero contributes nothing, even if its
/// derivative is infinite.
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
