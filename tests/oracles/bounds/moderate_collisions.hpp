// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <carom/oracles/bounds/inputs.hpp>
#include <carom/oracles/bounds/moderate.hpp>
#include <carom/oracles/truths/models.hpp>

#include "support/magnitude.hpp"

/// Collisions whose numbers are all at the limits of `is_moderate`. Tests run the laws on them with `Magnitude`. One of
/// these collisions gives the largest result of all moderate collisions, because the logarithm of a result is convex in
/// the logarithms of the inputs (docs/internals/bounds.md).
namespace carom::bounds {

/// A corner of the moderate domain. Numbers in numerators have the largest size. Masses, moments and directions also
/// occur in denominators, so they have the largest or the smallest size.
struct Corner {
  bool is_light;  // masses and moments are the smallest, else the largest
  double orientation_a;
  double orientation_b;
  double normal;
  bool a_immovable;
  bool b_immovable;
};

[[nodiscard]] inline std::vector<Corner> corners() {
  using oracles::largest_moderate_direction;
  using oracles::smallest_moderate_direction;
  std::vector<Corner> all;
  for (const bool is_light : {true, false}) {
    for (const double a : {smallest_moderate_direction, largest_moderate_direction}) {
      for (const double b : {smallest_moderate_direction, largest_moderate_direction}) {
        for (const double n : {smallest_moderate_direction, largest_moderate_direction}) {
          for (const int immovable : {0, 1, 2}) {
            all.push_back({is_light, a, b, n, immovable == 1, immovable == 2});
          }
        }
      }
    }
  }
  return all;
}

[[nodiscard]] inline Collision collision_at(const Corner& corner) {
  constexpr double most = oracles::largest_moderate;
  const Vector3<double> largest{most, most, most};
  Collision c;
  for (Body* body : {&c.a, &c.b}) {
    body->mass = corner.is_light ? oracles::smallest_moderate : oracles::largest_moderate_mass;
    body->principal_inertia.setConstant(corner.is_light ? oracles::smallest_moderate_moment
                                                        : oracles::largest_moderate_moment);
    body->position = largest;
    body->velocity = largest;
    body->angular_velocity = largest;
  }
  c.a.immovable = corner.a_immovable;
  c.b.immovable = corner.b_immovable;
  c.a.orientation.setConstant(corner.orientation_a);
  c.b.orientation.setConstant(corner.orientation_b);
  c.point = largest;
  c.normal.setConstant(corner.normal);
  c.restitution = 1;
  c.friction = most;
  c.tangential_restitution = 1;
  return c;
}

/// Lets all components of a direction except the first be smaller.
template <class Direction>
void leave_one_component(Direction& direction) {
  for (int i = 1; i < direction.size(); ++i) {
    direction[i].value = Magnitude::at_most(std::exp2(direction[i].value.above()));
  }
}

[[nodiscard]] inline oracles::DualInputs<Magnitude, oracles::collision_inputs> differentiated(const Collision& c) {
  auto inputs = oracles::dual_inputs<Magnitude, oracles::collision_inputs>(c, [](double x) { return Magnitude(x); });
  leave_one_component(inputs.collision.a.orientation);
  leave_one_component(inputs.collision.b.orientation);
  leave_one_component(inputs.collision.normal);
  // The length of a position includes the extent, which may be as large as a moderate number.
  std::size_t first = 0;
  for_each_number(
      [&](const FieldPath& path, const double&) {
        if (path.field == "position" && path.component == 0) {
          for (oracles::Quantity& q : inputs.quantities) {
            q.length += q.first == first ? oracles::largest_moderate : 0;
          }
        }
        ++first;
      },
      c);
  return inputs;
}

[[nodiscard]] inline Outcome<double> largest_outcome() {
  return map_outcome<double>(Outcome<double>{}, [](double) { return oracles::largest_moderate_outcome; });
}

[[nodiscard]] inline Magnitude length(const Vector3<Magnitude>& v) { return sqrt(v.squaredNorm()); }

}  // namespace carom::bounds

namespace carom::oracles {

using MagnitudeDual = Dual<bounds::Magnitude, collision_inputs>;

/// Bounds the solution x of K x = b and its derivative dx without Cramer's rule, whose bounds are useless. As λI ⪯ K
/// (ExactCase::is_definite), ‖x‖ ≤ ‖b‖ / λ and ‖dx‖ ≤ (‖db‖ + ‖dK‖ ‖x‖) / λ. λ = 1/m_A + 1/m_B is at least 1/M, with
/// the largest moderate mass M.
template <>
inline Vector3<MagnitudeDual> cramer<MagnitudeDual>(const Matrix3<MagnitudeDual>& k, const Vector3<MagnitudeDual>& b) {
  using bounds::Magnitude;
  const auto vector = [&](const auto& component) {
    return Vector3<Magnitude>{component(b[0]), component(b[1]), component(b[2])};
  };
  const Magnitude inverse_lambda = Magnitude::of_exponent(std::log2(largest_moderate_mass));
  const Magnitude x = length(vector([](const MagnitudeDual& of) { return of.value; })) * inverse_lambda;
  MagnitudeDual component(x);
  for (std::size_t j = 0; j < collision_inputs; ++j) {
    Magnitude of_matrix(0);
    for (int i = 0; i < 3; ++i) {
      for (int l = 0; l < 3; ++l) {
        of_matrix += k(i, l).derivative[j] * k(i, l).derivative[j];
      }
    }
    const Magnitude of_right = length(vector([&](const MagnitudeDual& of) { return of.derivative[j]; }));
    component.derivative[j] = (of_right + sqrt(of_matrix) * x) * inverse_lambda;
  }
  return Vector3<MagnitudeDual>::Constant(component);
}

}  // namespace carom::oracles
