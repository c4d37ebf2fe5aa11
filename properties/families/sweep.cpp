// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <carom/properties/families/bodies.hpp>
#include <carom/properties/families/sweep.hpp>

namespace carom::properties {
namespace {

/// One movable body with J = j I: the eigenvalues of K are then 1/m along r and 1/m + ‖r‖²/j across it, so that
/// κ(K) = 1 + m ‖r‖²/j.
Collision condition_number(Stream& stream, double condition) {
  Collision c = general_bodies(stream).collision;
  make_immovable(c.b);
  if (condition > 1) {
    const Vector3<double> lever_arm = c.point - c.a.position;
    c.a.principal_inertia.setConstant(c.a.mass * lever_arm.squaredNorm() / (condition - 1));
  } else {
    c.a.position = c.point;
  }
  make_approaching(c);
  return c;
}

Collision tangential_velocity(Stream& stream, double ratio) {
  Collision c = general_bodies(stream).collision;
  c.a.angular_velocity.setZero();
  c.b.angular_velocity.setZero();
  c.b.velocity.setZero();
  c.a.velocity = orthogonal(c.normal) * ratio - c.normal;
  return c;
}

Collision mass_ratio(Stream& stream, double ratio) {
  Collision c = general_bodies(stream).collision;
  Body& heavy = stream.chance(2) ? c.a : c.b;
  heavy.mass *= ratio;
  heavy.principal_inertia *= ratio;
  return c;
}

Collision mass_unit(Stream& stream, double unit) {
  Collision c = general_bodies(stream).collision;
  for (Body* body : {&c.a, &c.b}) {
    body->mass *= unit;
    body->principal_inertia *= unit;
  }
  return c;
}

Collision distance(Stream& stream, double metres) {
  Collision c = general_bodies(stream).collision;
  const Vector3<double> direction = stream.direction();
  const Vector3<double> offset = direction * (metres / std::sqrt(direction.dot(direction)));
  c.point += offset;
  c.a.position += offset;
  c.b.position += offset;
  make_approaching(c);
  return c;
}

Collision sphere_offset(Stream& stream, double radii) {
  Collision c = touching_spheres(stream).collision;
  c.point += orthogonal(c.normal) * radii;
  make_approaching(c);
  return c;
}

constexpr std::array sweeps{
    Sweep{"condition_number", "condition number κ(C)",
          "one body of equal moments of inertia against a wall, the moments ever smaller", 0, 20, condition_number},
    Sweep{"tangential_velocity", "v_t/v_n before the impulse", "general bodies without spin, ever closer to head-on", 0,
          -18, tangential_velocity},
    Sweep{"mass_ratio", "mass ratio", "general bodies, one of them ever heavier", 0, 20, mass_ratio},
    Sweep{"small_mass", "mass of both bodies, ever lighter [about 1 kg times this]",
          "general bodies, both ever lighter", 0, -30, mass_unit},
    Sweep{"large_mass", "mass of both bodies, ever heavier [about 1 kg times this]",
          "general bodies, both ever heavier", 0, 30, mass_unit},
    Sweep{"distance", "distance from the origin [m]", "general bodies of about 1 m, ever farther from the origin", 0,
          15, distance},
    Sweep{"sphere_offset", "offset of the contact from the line of centres [about 1 radius times this]",
          "touching spheres, the contact ever closer to the line of centres", -1, -17, sphere_offset},
};

}  // namespace

std::span<const Sweep> all_sweeps() { return sweeps; }

}  // namespace carom::properties
