// SPDX-License-Identifier: BSL-1.0
#include <array>

#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/friction.hpp>
#include <carom/properties/cases/needle_tip.hpp>
#include <carom/properties/draws/general_collision.hpp>
#include <carom/properties/draws/vectors.hpp>

namespace carom::properties {
namespace {

struct Needle {
  Body body;
  Vector3<double> axis;  // of about unit length, from the centre of mass to the tip
};

/// Zero, or 10^-k with k = 1 to 18.
double small_or_zero(Stream& stream) { return stream.chance(4) ? 0 : stream.power_of_ten(-18, -1); }

/// The needle has its tip, or a place near the tip, at `point`.
Needle needle(Stream& stream, const Vector3<double>& point) {
  // a² / S: a is the distance from the centre of mass to the tip, and S the mean of the squared coordinates along the
  // axis. The shapes are a prism struck on its end face, an ellipsoid, a double pyramid, and a pyramid with its apex.
  constexpr std::array squared_reaches{3.0, 5.0, 10.0, 15.0};
  const double squared_reach = squared_reaches[static_cast<std::size_t>(stream.integer(0, 3))];
  const int along = stream.integer(0, 2);
  const double length = stream.power_of_two(-3, 3);
  const double width = length * stream.power_of_ten(-6, -1);
  // At the share t of a below its tip, each shape contains the points within t/4 of its semi-widths.
  const double depth = small_or_zero(stream);
  Vector3<double> second_moments;
  Vector3<double> tip;
  for (int i = 0; i < 3; ++i) {
    const double semi_width = width * stream.between(0.5, 1.5);
    const double beside = semi_width * (depth / 4 * stream.signed_unit());
    second_moments[i] = i == along ? length * length / squared_reach : semi_width * semi_width / 5;
    tip[i] = i == along ? length * (1 - depth) : beside;
  }
  Vector3<double> axis{0, 0, 0};
  axis[along] = stream.chance(2) ? 1 : -1;
  tip[along] *= axis[along];
  Needle result;
  result.body.mass = drawn_mass(stream);
  result.body.principal_inertia = principal_moments(result.body.mass, second_moments);
  result.body.orientation = stream.quaternion();
  result.body.position = point - turned(result.body.orientation, tip);
  result.axis = turned(result.body.orientation, axis);
  set_velocities(stream, result.body, length);
  return result;
}

/// The body that the needle strikes.
Body struck_body(Stream& stream, const Vector3<double>& point) {
  switch (stream.integer(0, 2)) {
    case 0: {
      Body wall = convex_body(stream, point);
      make_immovable(wall);
      return wall;
    }
    case 1:
      return needle(stream, point).body;
    default:
      return convex_body(stream, point);
  }
}

}  // namespace

Case needle_tip(Stream& stream) {
  Case result;
  result.convex_uniform = true;
  Collision& c = result.collision;
  // From the origin, the rounded lever arms are −X, exactly.
  const double distance = stream.chance(2) ? 0 : stream.power_of_two(-2, 2);
  c.point = stream.vector() * distance;
  const bool a_is_needle = stream.chance(2);
  const Needle struck_on_tip = needle(stream, c.point);
  const Body other = struck_body(stream, c.point);
  c.a = a_is_needle ? struck_on_tip.body : other;
  c.b = a_is_needle ? other : struck_on_tip.body;
  const Vector3<double>& axis = struck_on_tip.axis;
  // N points from B to A: from the tip of A to its centre, or from the centre of B to its tip.
  c.normal = plus(axis * (a_is_needle ? -1.0 : 1.0), orthogonal(axis), small_or_zero(stream));
  const double speed = stream.power_of_two(-3, 3);
  set_relative_velocity(c, plus(c.normal * -speed, orthogonal(c.normal), speed * small_or_zero(stream)));
  c.restitution = drawn_restitution(stream);
  set_friction(stream, c);
  return result;
}

}  // namespace carom::properties
