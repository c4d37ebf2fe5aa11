// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/friction.hpp>
#include <carom/properties/cases/polyhedron.hpp>
#include <carom/properties/draws/general_collision.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/features/compose.hpp>

namespace carom::properties {
namespace {

PrincipalShape random_ellipsoid(Stream& stream) {
  const Vector3<double> direction = stream.direction();
  const double inside = stream.chance(2) ? 1 : stream.unit();
  const Vector3<double> on_unit_sphere = direction * (inside / length(direction));
  return {Vector3<double>::Constant(0.2), on_unit_sphere};
}

struct SizedShape {
  PrincipalShape shape;
  double size;
};

/// Random factors of a body's axes. At times, one axis is shorter (a plate), or two are (a rod).
Vector3<double> slenderness(Stream& stream) {
  Vector3<double> stretch{1, 1, 1};
  if (stream.chance(2)) {
    const double short_side = stream.power_of_ten(-4, 0);
    const int axis = stream.integer(0, 2);
    const bool is_plate = stream.chance(2);
    for (int i = 0; i < 3; ++i) {
      stretch[i] = (i == axis) == is_plate ? short_side : 1;
    }
  }
  return stretch;
}

SizedShape convex_shape(Stream& stream) {
  PrincipalShape shape = stream.chance(3) ? random_ellipsoid(stream) : random_polyhedron(stream);
  const double size = stream.power_of_two(-3, 3);
  const Vector3<double> slender = slenderness(stream);
  for (int i = 0; i < 3; ++i) {
    // A stretched ball is an ellipsoid, and a stretched polyhedron is a polyhedron.
    const double stretch = size * slender[i] * stream.between(0.5, 1.5);
    shape.second_moments[i] *= stretch * stretch;
    shape.point[i] *= stretch;
  }
  return {shape, size};
}

}  // namespace

Body convex_body(Stream& stream, const Vector3<double>& point) {
  Body body;
  const auto [shape, size] = convex_shape(stream);
  body.mass = drawn_mass(stream);
  body.principal_inertia = principal_moments(body.mass, shape.second_moments);
  body.orientation = stream.quaternion();
  body.position = point - turned(body.orientation, shape.point);
  set_velocities(stream, body, size);
  return body;
}

Case general_bodies(Stream& stream) { return {general_collision(stream), false}; }

Case sprinkled_bodies(Stream& stream) {
  Case bodies = general_bodies(stream);
  set_friction(stream, bodies.collision);
  sprinkle(stream, bodies.collision);
  return bodies;
}

Case convex_bodies(Stream& stream) {
  Case bodies{two_bodies(stream, convex_body), true};
  set_friction(stream, bodies.collision);
  return bodies;
}

Case touching_spheres(Stream& stream) {
  Case spheres;
  spheres.convex_uniform = true;
  Collision& c = spheres.collision;
  // All numbers have few bits, so X = P ± distance N is exact and the lever arms are parallel to N.
  for (int i = 0; i < 3; ++i) {
    c.normal[i] = stream.integer(-63, 63) / 64.0;
    c.point[i] = stream.integer(-64, 64) / 16.0;
  }
  if ((c.normal.array() == 0).all()) {
    c.normal[1] = 1;
  }
  for (Body* body : {&c.a, &c.b}) {
    const double distance = stream.integer(1, 32, 16) / 16.0;
    const double squared_radius = distance * distance * squared_length(c.normal);
    body->mass = drawn_mass(stream);
    // If the draw is plain (`Stream::plainly`), the ball has the moment m r²/2 and is not uniform.
    const bool is_uniform = !stream.plainly();
    spheres.convex_uniform = spheres.convex_uniform && is_uniform;
    const double moment = body->mass * squared_radius;
    body->principal_inertia.setConstant(is_uniform ? moment * 2 / 5 : moment / 2);
    body->orientation = stream.quaternion();
    body->position = plus(c.point, c.normal, body == &c.a ? distance : -distance);
    set_velocities(stream, *body, std::sqrt(squared_radius));
  }
  c.restitution = drawn_restitution(stream);
  if (dot(c.normal, relative_velocity(c)) > 0) {
    // Reverses the motion, because a reversed normal would point away from A.
    c.a.velocity = negated(c.a.velocity);
    c.b.velocity = negated(c.b.velocity);
  }
  set_friction(stream, c);
  stream.settle(c);
  return spheres;
}

}  // namespace carom::properties
