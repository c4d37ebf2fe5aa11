// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <carom/scene/polyhedra/contact_impulse.hpp>

#include "bodies.hpp"

namespace carom::scene {
namespace {

using unit::Vector;

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

Collision random_collision(std::uint64_t seed) {
  properties::Stream stream = properties::stream_from(seed);
  Collision collision;
  collision.a = random_struck(stream);
  collision.b = random_struck(stream);
  collision.b.immovable = seed % 3 == 0;
  collision.normal = stream.between(0.25, 4) * unit::unit_vector(stream);
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
  const Matrix3<double> axes = unit::matrix_of(body.orientation);
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

/// These tolerances cover about a hundred roundings of numbers of about 1, with moments that differ by a factor of 2,
/// and lever arms up to 2.
constexpr double in_double = 128 * 0x1p-53;
constexpr double in_float = 128 * 0x1p-24;

TEST(ContactImpulse, PartingSpeedIsThatOfThePoints) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Collision collision = random_collision(seed);
    EXPECT_NEAR(parting_speed(collision), parting(collision, unchanged(collision)), in_double) << "seed " << seed;
  }
  Collision collision = random_collision(1);
  const double speed = parting_speed(collision);
  for (const double length : {1e-300, 1e-150, 1e150, 1e300}) {
    Collision scaled = collision;
    scaled.normal = collision.normal * length;
    EXPECT_NEAR(parting_speed(scaled), speed, in_double) << length;
  }
}

TEST(ContactImpulse, SendsApartAtTheSpeedWhatIsSlower) {
  int raised = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Collision collision = random_collision(seed);
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

/// The definition of each law in terms of V, the velocity of A's contact point relative to B's.
class Laws : public testing::TestWithParam<Precision> {};

TEST_P(Laws, AreTheirDefinitions) {
  const double tolerance = GetParam() == Precision::binary32 ? in_float : in_double;
  int colliding = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Collision collision = random_collision(seed);
    const Vector n = collision.normal.normalized();
    const Vector before = relative_velocity(collision, unchanged(collision));
    const double approach = n.dot(before);
    if (approach > -0.01) {
      continue;
    }
    ++colliding;
    const Vector frictionless = relative_velocity(collision, struck_bodies(Law::frictionless, GetParam(), collision));
    for (const Law law : {Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb}) {
      SCOPED_TRACE(name_of(law));
      const Outcome<double> outcome = struck_bodies(law, GetParam(), collision);
      expect_one_impulse(collision, outcome, tolerance);
      const Vector after = relative_velocity(collision, outcome);
      const Vector slip = before - approach * n;
      const Vector slip_after = after - n.dot(after) * n;
      const Vector impulse = collision.a.mass * (outcome.a.velocity - collision.a.velocity);
      const double normal_impulse = n.dot(impulse);
      const double friction = (impulse - normal_impulse * n).norm();
      EXPECT_NEAR(n.dot(after), -collision.restitution * approach, tolerance);
      switch (law) {
        case Law::frictionless:
          EXPECT_LE(friction, tolerance);
          break;
        case Law::reflection:
          EXPECT_LE((slip_after - slip).norm(), tolerance);
          break;
        case Law::sticking:
          EXPECT_LE(slip_after.norm(), tolerance);
          break;
        case Law::rough:
        case Law::coulomb:
        case Law::any: {
          // The impulse P_I along the normal stops the approach, and P_II stops the contact point: K P_II = −V. Within
          // the friction cone, the impulse of `rough` is F = (1 + ε) P_I + (1 + e_t) (P_II − P_I). So the velocity
          // after is V' = −e_t V + (ε − e_t) K P_I. `stops` is K P_I, because `frictionless` changes V by (1 + ε) K
          // P_I.
          const double e_t = collision.tangential_restitution;
          const Vector stops = (frictionless - before) / (1 + collision.restitution);
          const Vector within =
              law == Law::rough ? Vector(after + e_t * before - (collision.restitution - e_t) * stops) : slip_after;
          const bool is_within = within.norm() <= tolerance;
          const bool is_on_cone = std::abs(friction - collision.friction * normal_impulse) <= tolerance;
          EXPECT_TRUE(is_within || is_on_cone) << friction << " of " << normal_impulse;
          EXPECT_LE(friction, collision.friction * normal_impulse + tolerance);
          break;
        }
      }
    }
  }
  EXPECT_GT(colliding, 80);
}

INSTANTIATE_TEST_SUITE_P(ContactImpulse, Laws,
                         testing::Values(Precision::binary32, Precision::binary64, Precision::extended),
                         [](const auto& precision) { return std::string(name_of(precision.param)); });

}  // namespace
}  // namespace carom::scene
