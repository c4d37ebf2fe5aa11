// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <gtest/gtest.h>

#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/rough.hpp>
#include <carom/impulse/solve3.hpp>
#include <carom/impulse/sticking.hpp>
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

Outcome<double> generic(Law law, const Collision& collision) {
  using impulse::Ldlt;
  Collision changed = collision;
  switch (law) {
    case Law::frictionless:
      return impulse::frictionless<double>(impulse::make_contact<double>(changed));
    case Law::reflection:
      return impulse::reflection<Ldlt, double>(impulse::make_contact<double>(changed));
    case Law::sticking:
      return impulse::sticking<Ldlt, double>(impulse::make_contact<double>(changed));
    case Law::coulomb:
      return impulse::coulomb<double>(impulse::make_contact<double>(changed));
    case Law::rough:
    case Law::any:
      break;
  }
  return impulse::rough<Ldlt, double>(impulse::make_contact<double>(changed));
}

constexpr std::array laws{Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb};

TEST(Impact, AgreesWithTheGenericSolversWithinUlps) {
  for (const Law law : laws) {
    properties::Stream stream = properties::stream_from(1);
    for (int i = 0; i < 300; ++i) {
      const Collision collision = random_collision(stream);
      const auto expected = generic(law, collision);
      for (const Precision precision : {Precision::binary32, Precision::binary64, Precision::extended}) {
        const Outcome<double> found = struck(law, precision, collision);
        // Both solvers have at most about 40 roundings of speeds of a few m/s, which 128 u covers. A rounding of the
        // impulse changes an angular velocity by up to 5/(2 R) = 12.5 times its effect on the velocity, which `size`
        // covers.
        const double u = std::max(roundoff, unit_roundoff(precision));
        const double size = 16;
        const auto ours = vectors(found);
        const auto theirs = vectors(expected);
        for (const OutcomeVector k : all_outcome_vectors) {
          EXPECT_LE((*ours[k] - *theirs[k]).cwiseAbs().maxCoeff(), 128 * u * size)
              << name_of(k) << " of case " << i << " under " << name_of(law);
        }
      }
    }
  }
}

TEST(Impact, WithoutFrictionLeavesTheBitsOfTheSpins) {
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

TEST(Impact, LeavesAPlaneWhereItIs) {
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

TEST(KeepApart, IsExact) {
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

TEST(KeepApart, IsExactBesideAPlane) {
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

TEST(KeepApart, LeavesWhatRecedes) {
  Vector va{1, 2, 3};
  Vector vb{0, 2, 3};
  keep_apart({1, 0, 0}, {0, 0, 0}, va, vb);
  EXPECT_EQ(va, Vector(1, 2, 3));
  EXPECT_EQ(vb, Vector(0, 2, 3));
}

}  // namespace
}  // namespace carom::scene
