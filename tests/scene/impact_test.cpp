// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <carom/scene/crossing.hpp>
#include <carom/scene/impact.hpp>

#include "paths.hpp"

namespace carom::scene {
namespace {

using unit::Rational;
using unit::Vector;

StruckSphere random_sphere(properties::Stream& stream, const Vector& position, double radius) {
  StruckSphere sphere;
  sphere.radius = radius;
  sphere.mass = stream.between(0.5, 4);
  sphere.moment = 0.4 * sphere.mass * radius * radius;
  sphere.position = position;
  sphere.velocity = stream.vector();
  sphere.angular_velocity = 3 * stream.vector();
  return sphere;
}

Collision random_collision(properties::Stream& stream) {
  const Vector normal = stream.direction().normalized();
  StruckSphere a = random_sphere(stream, 2 * stream.vector(), stream.between(0.2, 1));
  const double radius = stream.between(0.2, 1);
  StruckSphere b = random_sphere(stream, a.position - (a.radius + radius) * normal, radius);
  const bool on_plane = stream.chance(3);
  const double apart = normal.dot(on_plane ? a.velocity : Vector(a.velocity - b.velocity));
  a.velocity -= (std::max(apart, 0.0) + 0.25) * normal;
  const MaterialPair pair{stream.unit(), stream.unit(), stream.signed_unit(), 0, 0};
  return on_plane ? collision_with_plane(a, normal * stream.between(0.5, 2), pair) : collision_of(a, b, pair);
}

constexpr std::array laws{Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb};

TEST(Struck, LeavesTheBitsOfTheSpinsOfSpheresWithoutFriction) {
  properties::Stream stream = properties::stream_from(2);
  for (int i = 0; i < 300; ++i) {
    const Collision collision = random_collision(stream);
    for (const Law law : {Law::frictionless, Law::reflection}) {
      for (const Precision precision : {Precision::binary32, Precision::binary64, Precision::extended}) {
        const Outcome<double> found = struck(law, precision, collision);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_TRUE(unit::same_bits(found.a.angular_velocity[axis], collision.a.angular_velocity[axis]));
          EXPECT_TRUE(unit::same_bits(found.b.angular_velocity[axis], collision.b.angular_velocity[axis]));
        }
        EXPECT_NE(found.a.velocity, collision.a.velocity);
      }
    }
  }
}

TEST(Struck, LeavesAPlaneAtRest) {
  properties::Stream stream = properties::stream_from(3);
  const StruckSphere sphere = random_sphere(stream, {0, 0, 1}, 1);
  StruckSphere falling = sphere;
  falling.velocity.z() = -1;
  const Collision collision = collision_with_plane(falling, {0, 0, 2}, {0.5, 0.25, 0.5, 0, 0});
  for (const Law law : laws) {
    const Outcome<double> found = struck(law, Precision::binary32, collision);
    EXPECT_EQ(found.b.velocity, Vector(0, 0, 0));
    EXPECT_EQ(found.b.angular_velocity, Vector(0, 0, 0));
  }
}

Rational exact_dot(const Vector& x, const Vector& y) {
  Rational sum(0);
  for (int axis = 0; axis < 3; ++axis) {
    sum += Rational(x[axis]) * Rational(y[axis]);
  }
  return sum;
}

TEST(KeepApart, LeavesNoApproachOfSpheresExactly) {
  properties::Stream stream = properties::stream_from(4);
  int changed = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector a = stream.vector();
    const Vector b = 2 * stream.vector();
    Vector va = stream.vector();
    Vector vb = stream.vector();
    // As after an impact with ε = 0, there is no speed along the normal, up to rounding.
    const Vector n = (a - b).normalized();
    va += n.dot(vb - va) * n;
    const Vector before = va;
    const Vector other = vb;
    keep_apart(a, b, va, vb);
    Rational apart(0);
    for (int axis = 0; axis < 3; ++axis) {
      apart += (Rational(a[axis]) - Rational(b[axis])) * (Rational(va[axis]) - Rational(vb[axis]));
    }
    EXPECT_TRUE(apart >= 0);
    changed += va == before ? 0 : 1;
    // The change is a few ulps: the approach is about 8 u of speeds up to 4, and is divided by a component of n of at
    // least 1/√3.
    EXPECT_LE((va - before).norm() + (vb - other).norm(), 64 * roundoff * 4);
  }
  EXPECT_GT(changed, 200);
  EXPECT_LT(changed, 1800);
}

TEST(KeepApart, LeavesNoApproachToAPlaneExactly) {
  properties::Stream stream = properties::stream_from(5);
  int changed = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector n = stream.direction();
    Vector v = stream.vector();
    v -= n.dot(v) / n.squaredNorm() * n;
    const Vector before = v;
    keep_apart(n, v);
    EXPECT_TRUE(exact_dot(n, v) >= 0);
    changed += v == before ? 0 : 1;
    EXPECT_LE((v - before).norm(), 64 * roundoff * 2);
  }
  EXPECT_GT(changed, 200);
  EXPECT_LT(changed, 1800);
}

TEST(KeepApart, LeavesSpheresThatRecede) {
  Vector va{1, 2, 3};
  Vector vb{0, 2, 3};
  keep_apart({1, 0, 0}, {0, 0, 0}, va, vb);
  EXPECT_EQ(va, Vector(1, 2, 3));
  EXPECT_EQ(vb, Vector(0, 2, 3));
}

Body random_struck(properties::Stream& stream) {
  Body body;
  body.mass = stream.between(0.5, 2);
  body.principal_inertia = Vector(stream.between(0.5, 1), stream.between(0.5, 1), stream.between(0.5, 1));
  body.orientation = stream.quaternion();
  body.position = stream.vector();
  body.velocity = stream.vector();
  body.angular_velocity = stream.vector();
  return body;
}

Collision collision_of_bodies(std::uint64_t seed) {
  properties::Stream stream = properties::stream_from(seed);
  Collision collision;
  collision.a = random_struck(stream);
  collision.b = random_struck(stream);
  collision.b.immovable = seed % 3 == 0;
  collision.normal = stream.between(0.25, 4) * stream.direction().normalized();
  collision.restitution = stream.between(0, 1);
  collision.friction = stream.between(0, 1);
  collision.tangential_restitution = stream.between(-1, 1);
  return collision;
}

Vector point_velocity(const Body& body, const BodyVelocity<double>& v, const Vector& point) {
  return v.velocity + v.angular_velocity.cross(point - body.position);
}

Vector relative_velocity(const Collision& collision, const Outcome<double>& outcome) {
  return point_velocity(collision.a, outcome.a, collision.point) -
         point_velocity(collision.b, outcome.b, collision.point);
}

double parting(const Collision& collision, const Outcome<double>& outcome) {
  return collision.normal.dot(relative_velocity(collision, outcome)) / collision.normal.norm();
}

Vector spin_of(const Body& body, const Vector& angular_velocity) {
  const Quaternion<double>& q = body.orientation;
  const Matrix3<double> axes = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  return axes * body.principal_inertia.cwiseProduct(axes.transpose() * angular_velocity);
}

/// Checks that A and B receive opposite impulses at the contact point, for numbers of about 1.
void expect_one_impulse(const Collision& collision, const Outcome<double>& outcome, double tolerance) {
  const Vector impulse = collision.a.mass * (outcome.a.velocity - collision.a.velocity);
  const auto torque_differs = [&](const Body& body, const BodyVelocity<double>& v, const Vector& on_body) {
    return (spin_of(body, v.angular_velocity - body.angular_velocity) -
            (collision.point - body.position).cross(on_body))
        .norm();
  };
  EXPECT_LE(torque_differs(collision.a, outcome.a, impulse), tolerance);
  if (collision.b.immovable) {
    EXPECT_EQ(outcome.b.velocity, collision.b.velocity);
    EXPECT_EQ(outcome.b.angular_velocity, collision.b.angular_velocity);
  } else {
    EXPECT_LE((collision.b.mass * (outcome.b.velocity - collision.b.velocity) + impulse).norm(), tolerance);
    EXPECT_LE(torque_differs(collision.b, outcome.b, -impulse), tolerance);
  }
}

/// This tolerance covers about a hundred roundings of numbers of about 1, with moments that differ by a factor of 2,
/// and lever arms up to 2.
constexpr double in_double = 128 * 0x1p-53;

TEST(PartingSpeed, IsTheNormalSpeedOfTheContactPointsForNormalsOfAnyLength) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Collision collision = collision_of_bodies(seed);
    EXPECT_NEAR(parting_speed(collision), parting(collision, unchanged(collision)), in_double) << "seed " << seed;
  }
  Collision collision = collision_of_bodies(1);
  const double speed = parting_speed(collision);
  for (const double length : {1e-300, 1e-150, 1e150, 1e300}) {
    Collision scaled = collision;
    scaled.normal = collision.normal * length;
    EXPECT_NEAR(parting_speed(scaled), speed, in_double) << length;
  }
}

TEST(SentApart, GivesBodiesThatAreSlowerTheSpeedByOneImpulse) {
  int raised = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Collision collision = collision_of_bodies(seed);
    const double before = parting_speed(collision);
    for (const double speed : {0.0, 1e-9, 0.5, 2.0}) {
      const Outcome<double> apart = sent_apart(collision, speed);
      if (before < speed) {
        ++raised;
        EXPECT_NEAR(parting(collision, apart), speed, in_double);
        expect_one_impulse(collision, apart, in_double);
        EXPECT_LE((apart.a.velocity - collision.a.velocity).cross(collision.normal).norm(),
                  in_double * collision.normal.norm());
      } else {
        EXPECT_EQ(apart.a.velocity, collision.a.velocity);
        EXPECT_EQ(apart.b.velocity, collision.b.velocity);
        EXPECT_EQ(apart.a.angular_velocity, collision.a.angular_velocity);
        EXPECT_EQ(apart.b.angular_velocity, collision.b.angular_velocity);
      }
    }
  }
  EXPECT_GT(raised, 500);
}

}  // namespace
}  // namespace carom::scene
