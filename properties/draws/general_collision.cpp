// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/draws/general_collision.hpp>
#include <carom/properties/draws/vectors.hpp>

namespace carom::properties {

double drawn_restitution(Stream& stream) {
  switch (stream.integer(0, 3)) {
    case 0:
      return 0;
    case 1:
      return 1;
    default:
      return stream.unit();
  }
}

void set_velocities(Stream& stream, Body& body, double size) {
  const double speed = stream.power_of_two(-3, 3);
  body.velocity = stream.vector() * speed;
  body.angular_velocity = stream.vector() * (speed / size);
}

Vector3<double> principal_moments(double mass, const Vector3<double>& s) {
  return Vector3<double>{s[1] + s[2], s[0] + s[2], s[0] + s[1]} * mass;
}

double drawn_mass(Stream& stream) {
  const double octave = stream.power_of_two(-6, 6);
  return octave * (1 + stream.unit());
}

namespace {

Body general_body(Stream& stream, const Vector3<double>& point) {
  Body body;
  const double size = stream.power_of_two(-3, 3);
  body.mass = drawn_mass(stream);
  Vector3<double> second_moments;
  for (int i = 0; i < 3; ++i) {
    const double semi_axis = size * stream.between(0.5, 1);
    second_moments[i] = semi_axis * semi_axis / 5;
  }
  body.principal_inertia = stream.plainly() ? Vector3<double>(Vector3<double>::Constant(body.mass * size * size))
                                            : principal_moments(body.mass, second_moments);
  body.orientation = stream.quaternion();
  body.position = plus(point, stream.vector(), -size);
  set_velocities(stream, body, size);
  return body;
}

}  // namespace

Collision general_collision(Stream& stream) { return two_bodies(stream, general_body); }

}  // namespace carom::properties
