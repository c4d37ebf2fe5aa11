// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>

#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/friction.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>

namespace carom::properties {
namespace {

/// The velocity that a unit impulse along this axis at the contact point gives to the body there: a column of I/m +
/// [r]ᵀ J⁻¹ [r], with the identity I.
Vector3<double> mobility(const Body& body, const Vector3<double>& point, const Vector3<double>& axis) {
  if (body.immovable) {
    return Vector3<double>::Zero();
  }
  const Vector3<double> arm = point - body.position;
  const Vector3<double> torque = turned(conjugate(body.orientation), cross(arm, axis));
  const Vector3<double> spin = turned(body.orientation, torque.cwiseQuotient(body.principal_inertia));
  return axis / body.mass + cross(spin, arm);
}

Case rubbing_bodies(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  if (stream.chance(3)) {
    make_immovable(stream.chance(2) ? result.collision.a : result.collision.b);
    make_approaching(result.collision);
    stream.settle(result.collision);
  }
  return result;
}

}  // namespace

void set_friction(Stream& stream, Collision& collision) {
  switch (stream.integer(0, 3)) {
    case 0:
      collision.friction = 0;
      break;
    case 1:
      collision.friction = stream.power_of_ten(-4, 2);
      break;
    default:
      collision.friction = stream.unit();
  }
  switch (stream.integer(0, 3)) {
    case 0:
      collision.tangential_restitution = 0;
      break;
    case 1:
      collision.tangential_restitution = stream.chance(2) ? 1 : -1;
      break;
    default:
      collision.tangential_restitution = stream.between(-1, 1);
  }
}

namespace {

Columns mobility(const Collision& c) {
  const auto along = [&](const Vector3<double>& axis) {
    return Vector3<double>(mobility(c.a, c.point, axis) + mobility(c.b, c.point, axis));
  };
  return {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
}

/// The μ at which an impulse lies on the friction cone's surface; 1 if there is none.
double friction_of(const Vector3<double>& n, const Vector3<double>& impulse) {
  const double friction = length(cross(n, impulse)) / dot(n, impulse);
  return std::isfinite(friction) && friction > 0 ? friction : 1;
}

/// 1 ± 10^-k.
double nearly_one(Stream& stream) {
  const double beside = stream.power_of_ten(-18, -1);
  return stream.chance(2) ? 1 + beside : 1 - beside;
}

}  // namespace

double critical_friction(const Collision& c) {
  const Columns k = mobility(c);
  const Vector3<double> v = relative_velocity(c);
  const Vector3<double>& n = c.normal;
  const Vector3<double> stops_approach = n * (-dot(n, v) / dot(n, product(k, n)));
  const Vector3<double> friction = negated(solution(k, v + product(k, stops_approach)));
  const Vector3<double> whole = plus(stops_approach * (1 + c.restitution), friction, 1 + c.tangential_restitution);
  return friction_of(n, whole);
}

double friction_that_sticks(const Collision& c) {
  const Vector3<double> v = relative_velocity(c);
  const Vector3<double>& n = c.normal;
  const Vector3<double> departure = n * (c.restitution * dot(n, v) / squared_length(n));
  return friction_of(n, negated(solution(mobility(c), v + departure)));
}

Case sticking(Stream& stream) {
  Case result = rubbing_bodies(stream);
  result.collision.friction = critical_friction(result.collision) * (1 + stream.power_of_ten(-3, 2));
  return result;
}

Case sliding(Stream& stream) {
  Case result = rubbing_bodies(stream);
  result.collision.friction = critical_friction(result.collision) * stream.unit();
  return result;
}

Case on_the_cone(Stream& stream) {
  Case result = rubbing_bodies(stream);
  result.collision.friction = critical_friction(result.collision) * nearly_one(stream);
  return result;
}

Case stick_or_slip(Stream& stream) {
  Case result = rubbing_bodies(stream);
  result.collision.friction = friction_that_sticks(result.collision) * nearly_one(stream);
  return result;
}

Case no_friction(Stream& stream) {
  Case result = rubbing_bodies(stream);
  result.collision.friction = 0;
  return result;
}

Case great_friction(Stream& stream) {
  Case result = rubbing_bodies(stream);
  result.collision.friction = stream.power_of_ten(0, 9);
  return result;
}

Case spin_alone(Stream& stream) {
  Case result = touching_spheres(stream);
  Collision& c = result.collision;
  if (stream.chance(3)) {
    make_immovable(stream.chance(2) ? c.a : c.b);
  }
  c.a.velocity.setZero();
  c.b.velocity.setZero();
  const Vector3<double> approach = c.normal * stream.between(0.125, 8);
  if (c.a.immovable) {
    c.b.velocity = approach;
  } else {
    c.a.velocity = negated(approach);
  }
  set_friction(stream, c);
  return result;
}

Case special_tangential_restitution(Stream& stream) {
  Case result = rubbing_bodies(stream);
  constexpr std::array special{-1.0, 0.0, 1.0};
  result.collision.tangential_restitution = special[static_cast<std::size_t>(stream.integer(0, 2))];
  return result;
}

}  // namespace carom::properties
