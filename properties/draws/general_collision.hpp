// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/stream.hpp>
#include <carom/properties/draws/vectors.hpp>

namespace carom::properties {

/// The restitution ε: 0, 1, or a number between them.
[[nodiscard]] double drawn_restitution(Stream& stream);

/// From 2⁻⁶ kg to 2⁷ kg.
[[nodiscard]] double drawn_mass(Stream& stream);

/// Draws velocities for a body of this size [m]. Rotation moves the surface about as fast as the centre moves.
void set_velocities(Stream& stream, Body& body, double size);

/// Principal moments of a body with these second moments per mass: I_x = m (S_y + S_z), and so on.
[[nodiscard]] Vector3<double> principal_moments(double mass, const Vector3<double>& second_moments);

/// Two approaching bodies with any normal. `make_body(stream, contact point)` makes each body.
template <class MakeBody>
[[nodiscard]] Collision two_bodies(Stream& stream, MakeBody make_body) {
  Collision collision;
  const double distance = stream.power_of_two(-2, 2);
  collision.point = stream.vector() * distance;
  collision.a = make_body(stream, collision.point);
  collision.b = make_body(stream, collision.point);
  collision.normal = stream.direction();
  collision.restitution = drawn_restitution(stream);
  make_approaching(collision);
  stream.settle(collision);
  return collision;
}

/// Two approaching bodies of general inertia. The contact is at most about one body size from each centre of mass.
[[nodiscard]] Collision general_collision(Stream& stream);

/// The greatest principal moment of a body over its least; 0 if the body is immovable.
[[nodiscard]] inline double moment_ratio(const Body& body) {
  return body.immovable ? 0 : greatest(body.principal_inertia) / least(body.principal_inertia);
}

}  // namespace carom::properties
