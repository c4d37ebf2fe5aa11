// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>

#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/friction.hpp>
#include <carom/properties/cases/sweep.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties {
namespace {

/// One movable body with moment of inertia matrix J = j I. K has the eigenvalues 1/m along r and 1/m + ‖r‖²/j across
/// it, so κ(K) = 1 + m ‖r‖²/j.
Collision condition_number(Stream& stream, double condition) {
  Collision c = general_bodies(stream).collision;
  make_immovable(c.b);
  if (condition > 1) {
    const Vector3<double> lever_arm = c.point - c.a.position;
    c.a.principal_inertia.setConstant(c.a.mass * squared_length(lever_arm) / (condition - 1));
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
  c.a.velocity = plus(negated(c.normal), orthogonal(c.normal), ratio);
  return c;
}

Collision mass_ratio(Stream& stream, double ratio) {
  Collision c = general_bodies(stream).collision;
  Body& heavy = stream.chance(2) ? c.a : c.b;
  features::scale_mass(heavy, ratio);
  return c;
}

Collision mass_unit(Stream& stream, double unit) {
  Collision c = general_bodies(stream).collision;
  for (Body* body : {&c.a, &c.b}) {
    features::scale_mass(*body, unit);
  }
  return c;
}

Collision distance(Stream& stream, double metres) {
  Collision c = general_bodies(stream).collision;
  const Vector3<double> direction = stream.direction();
  const Vector3<double> offset = direction * (metres / length(direction));
  c.point += offset;
  c.a.position += offset;
  c.b.position += offset;
  make_approaching(c);
  return c;
}

/// A rod with moments 1 : ratio : ratio. The contact is about on the rod, at 0.5 to 1 radii of gyration from the
/// centre.
Collision slenderness(Stream& stream, double ratio) {
  Collision c = general_bodies(stream).collision;
  const double thinness = 1 / std::sqrt(ratio);
  Body& body = c.a;
  body.principal_inertia = Vector3<double>{1 / ratio, 1, 1} * greatest(body.principal_inertia);
  const double length = std::sqrt(body.principal_inertia[1] / body.mass);
  const Vector3<double> on_axis{length * stream.between(0.5, 1), 0, 0};
  const Vector3<double> in_body = plus(on_axis, stream.vector(), length * thinness);
  body.position = c.point - turned(body.orientation, in_body);
  make_approaching(c);
  return c;
}

Collision moments_of_no_body(Stream& stream, double excess) {
  Collision c = general_bodies(stream).collision;
  set_moment_excess(stream, c.a, excess);
  strike_close(stream, c, c.a);
  make_approaching(c);
  return c;
}

Collision size(Stream& stream, double ratio) {
  Collision c = general_bodies(stream).collision;
  c.point *= ratio;
  for (Body* body : {&c.a, &c.b}) {
    body->position *= ratio;
    body->velocity *= ratio;
    body->principal_inertia *= ratio * ratio;
  }
  return c;
}

/// Scales body A by `ratio` at the same density.
Collision size_ratio(Stream& stream, double ratio) {
  Collision c = general_bodies(stream).collision;
  const Vector3<double> lever_arm = c.point - c.a.position;
  c.a.position = plus(c.point, lever_arm, -ratio);
  c.a.mass *= ratio * ratio * ratio;
  c.a.principal_inertia *= ratio * ratio * ratio * ratio * ratio;
  c.a.angular_velocity /= ratio;
  make_approaching(c);
  return c;
}

Collision small_restitution(Stream& stream, double restitution) {
  Collision c = general_bodies(stream).collision;
  c.restitution = restitution;
  return c;
}

Collision sphere_offset(Stream& stream, double radii) {
  Collision c = touching_spheres(stream).collision;
  c.point = plus(c.point, orthogonal(c.normal), radii);
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
    Sweep{"slenderness", "ratio of the greatest to the least moment of inertia of a rod",
          "a rod and a general body, the rod ever more slender", 0, 12, slenderness},
    Sweep{"moment_excess", "a moment over the sum of the other two (at most 1 for any body)",
          "a body with moments that no distribution of mass has, and a general body", 0, 16, moments_of_no_body},
    Sweep{"small_size", "size of both bodies, ever smaller [about 1 m times this]",
          "general bodies, both ever smaller, and their velocities with them", 0, -12, size},
    Sweep{"large_size", "size of both bodies, ever larger [about 1 m times this]",
          "general bodies, both ever larger, and their velocities with them", 0, 12, size},
    Sweep{"size_ratio", "ratio of the sizes of the bodies", "general bodies of one density, one of them ever larger", 0,
          9, size_ratio},
    Sweep{"small_restitution", "restitution", "general bodies, the restitution ever smaller", 0, -18,
          small_restitution},
    Sweep{"sphere_offset", "offset of the contact from the line of centres [about 1 radius times this]",
          "touching spheres, the contact ever closer to the line of centres", -1, -17, sphere_offset},
};

}  // namespace

std::vector<double> Sweep::quantities() const {
  std::vector<double> all;
  const int step = first_exponent < last_exponent ? 1 : -1;
  for (int k = first_exponent; k != last_exponent + step; k += step) {
    all.push_back(power_of_ten(k));
  }
  return all;
}

Collision Sweep::generate(Stream& stream, double at_quantity) const {
  Collision collision = draw(stream, at_quantity);
  set_friction(stream, collision);
  return collision;
}

std::span<const Sweep> all_sweeps() { return sweeps; }

}  // namespace carom::properties
