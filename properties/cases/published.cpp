// SPDX-License-Identifier: BSL-1.0
#include <numbers>
#include <stdexcept>

#include <carom/properties/cases/published.hpp>
#include <carom/properties/draws/vectors.hpp>

namespace carom::properties {
namespace {

Body sphere(double radius, double height) {
  constexpr double density = 2700;  // [kg/m³]
  Body body;
  body.mass = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
  body.principal_inertia.setConstant(body.mass * radius * radius * 2 / 5);
  body.position = {0, height, 0};
  return body;
}

Collision on_a_plane(double radius) {
  Collision c;
  c.a = sphere(radius, radius);
  c.b.immovable = true;
  return c;
}

/// B is below A.
Collision two_spheres(double radius_a, double radius_b) {
  Collision c;
  c.a = sphere(radius_a, radius_a);
  c.b = sphere(radius_b, -radius_b);
  return c;
}

Collision two_equal_spheres(double radius, double speed) {
  Collision c = two_spheres(radius, radius);
  c.a.velocity = {0, -speed, 0};
  c.b.velocity = {0, speed, 0};
  return c;
}

/// The velocity of this speed [m/s] at the angle of incidence θ, given by tan(θ/2). Its components are rational in
/// tan(θ/2), so they are the same on every machine.
Vector3<double> oblique(double speed, double tangent_of_half) {
  const double squared = tangent_of_half * tangent_of_half;
  return {speed * (2 * tangent_of_half / (1 + squared)), -speed * ((1 - squared) / (1 + squared)), 0};
}

}  // namespace

Case chung_ooi_impact(int number, Stream& stream) {
  Collision c;
  const auto set = [&](double restitution, double friction) {
    c.restitution = restitution;
    c.friction = friction;
  };
  const auto spin = [&] { return Vector3<double>{0, 0, stream.between(-24, 24)}; };  // [rad/s]
  switch (number) {
    case 1:
      c = two_equal_spheres(0.01, 10);
      set(1, 0.35);
      break;
    case 2:
      c = on_a_plane(0.1);
      c.a.velocity = {0, -0.2, 0};
      set(1, 0.35);
      break;
    case 3:
      c = on_a_plane(0.0025);
      c.a.velocity = {0, -3.9, 0};
      set(stream.unit(), 0);
      break;
    case 4:
      c = on_a_plane(0.0025);
      c.a.velocity = oblique(3.9, stream.between(0.0078125, 0.984375));  // θ from 0.9° to 89°
      set(0.98, 0.092);
      break;
    case 5:
      c = on_a_plane(1e-5);
      c.a.velocity = {stream.between(0, 25), -5, 0};
      set(1, 0.3);
      break;
    case 6:
      c = on_a_plane(0.1);
      c.a.velocity = {0, -0.2, 0};
      c.a.angular_velocity = spin();
      set(0.5, 0.4);
      break;
    case 7:
      c = two_equal_spheres(0.1, 0.2);
      c.a.angular_velocity = spin();
      c.b.angular_velocity = negated(c.a.angular_velocity);
      set(0.5, 0.4);
      break;
    case 8:
      c = two_spheres(0.1, stream.between(0.1, 1));
      c.a.velocity = {0, -0.2, 0};
      c.a.angular_velocity = spin();
      c.b.angular_velocity = spin();
      set(0.5, 0.4);
      break;
    default:
      throw std::invalid_argument("chung_ooi_impact: expected a number from 1 to 8");
  }
  return {c, true};
}

Case chung_ooi(Stream& stream) { return chung_ooi_impact(stream.integer(1, chung_ooi_count), stream); }

}  // namespace carom::properties
