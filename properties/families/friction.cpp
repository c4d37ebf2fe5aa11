// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <Eigen/LU>

#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/families/bodies.hpp>
#include <carom/properties/families/friction.hpp>

namespace carom::properties {
namespace {

/// How fast the contact point of a body moves after a unit impulse at it, for each axis: 1/m + [r]ᵀ J⁻¹ [r].
Matrix3<double> mobility(const Body& body, const Vector3<double>& point) {
  Matrix3<double> result = Matrix3<double>::Zero();
  if (body.immovable) {
    return result;
  }
  const Vector3<double> arm = point - body.position;
  for (int i = 0; i < 3; ++i) {
    const Vector3<double> unit = Vector3<double>::Unit(i);
    const Vector3<double> torque = oracles::turned<double>(oracles::conjugate(body.orientation), arm.cross(unit));
    const Vector3<double> spin =
        oracles::turned<double>(body.orientation, Vector3<double>(torque.cwiseQuotient(body.principal_inertia)));
    result.col(i) = unit / body.mass + spin.cross(arm);
  }
  return result;
}

/// Two bodies or one and a wall, with μ and e_t.
Case rubbing_bodies(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  if (stream.chance(3)) {
    make_immovable(stream.chance(2) ? result.collision.a : result.collision.b);
    make_approaching(result.collision);
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

Matrix3<double> mobility(const Collision& c) { return mobility(c.a, c.point) + mobility(c.b, c.point); }

/// The μ at which an impulse lies on the cone's surface; 1 where there is none.
double friction_of(const Vector3<double>& n, const Vector3<double>& impulse) {
  const double friction = std::sqrt(n.cross(impulse).squaredNorm()) / n.dot(impulse);
  return std::isfinite(friction) && friction > 0 ? friction : 1;
}

/// 1 ± 10^-k.
double nearly_one(Stream& stream) {
  const double beside = stream.power_of_ten(-18, -1);
  return stream.chance(2) ? 1 + beside : 1 - beside;
}

}  // namespace

double critical_friction(const Collision& c) {
  const Matrix3<double> k = mobility(c);
  const Vector3<double> v = relative_velocity(c);
  const Vector3<double>& n = c.normal;
  const Vector3<double> k_normal = k * n;
  const Vector3<double> stops_approach = n * (-n.dot(v) / n.dot(k_normal));
  const Vector3<double> friction = -k.partialPivLu().solve(Vector3<double>(v + k * stops_approach));
  const Vector3<double> whole = (1 + c.restitution) * stops_approach + (1 + c.tangential_restitution) * friction;
  return friction_of(n, whole);
}

double friction_that_sticks(const Collision& c) {
  const Vector3<double> v = relative_velocity(c);
  const Vector3<double>& n = c.normal;
  const Vector3<double> departure = n * (c.restitution * n.dot(v) / n.squaredNorm());
  return friction_of(n, -mobility(c).partialPivLu().solve(Vector3<double>(v + departure)));
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

/// Spheres of which the spins alone make the contact slip; at times one of them and a wall.
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
    c.a.velocity = -approach;
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
