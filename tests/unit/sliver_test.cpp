// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/frictionless.hpp>
#include <carom/oracles/compare.hpp>
#include <carom/oracles/kinematics.hpp>
#include <carom/properties/families/bodies.hpp>

#include "cases.hpp"

/// What world coordinates cost slender and flat bodies. J⁻¹ = R diag(1/I) Rᵀ is rounded by u ‖J⁻¹‖ in each number, and
/// J times that is u ρ for moments 1 : ρ. Turned into the body frame, divided by the moments there and turned back, a
/// torque loses no more than a rotation of the body by u explains.
namespace carom::impulse {
namespace {

double ratio_of_moments(const Body& body) {
  return body.principal_inertia.maxCoeff() / body.principal_inertia.minCoeff();
}

/// The body compressed along one or two of its axes, to 2^−exponent of its width; the contact stays in or on it.
Body compressed(const Body& body, const Vector3<double>& point, int axis, bool others, int exponent) {
  const Vector3<double> moments = body.principal_inertia;
  Vector3<double> squares = Vector3<double>::Constant(moments.sum() / 2) - moments;
  Vector3<double> in_body = oracles::turned<double>(oracles::conjugate(body.orientation), point - body.position);
  for (int i = 0; i < 3; ++i) {
    if ((i == axis) != others) {
      squares[i] = std::ldexp(squares[i], -2 * exponent);
      in_body[i] = std::ldexp(in_body[i], -exponent);
    }
  }
  Body result = body;
  result.principal_inertia = {squares[1] + squares[2], squares[0] + squares[2], squares[0] + squares[1]};
  result.position = point - oracles::turned<double>(body.orientation, in_body);
  return result;
}

/// Slivers with moments 1 : ρ, least ≤ ρ < 2 least.
std::vector<Collision> slivers(double least, std::size_t count) {
  std::vector<Collision> result;
  properties::Stream stream = properties::stream_from(95);
  const int about = std::ilogb(least) / 2;  // moments go with the square of a width
  while (result.size() < count) {
    Collision c = properties::convex_bodies(stream).collision;
    c.a = compressed(c.a, c.point, stream.integer(0, 2), stream.chance(2),
                     stream.integer(std::max(0, about - 2), about + 1));
    properties::make_approaching(c);
    const double ratio = ratio_of_moments(c.a);
    if (ratio >= least && ratio < 2 * least) {
      result.push_back(c);
    }
  }
  return result;
}

/// The residual of J Δw = r × m Δv of A, in ulps of S.
template <class S>
double missed_angular_momentum(const Collision& collision, const Outcome<S>& outcome) {
  constexpr double least_that_is_shown = 0x1p-10;
  oracles::Yardstick yardstick;
  yardstick.unit_roundoff = std::numeric_limits<S>::epsilon() / 2;
  yardstick.limit_ulps = least_that_is_shown;
  const oracles::Comparison comparison = oracles::compare(
      oracles::law::AngularMomentum{true}, oracles::Relation::equal, oracles::ExactCase(collision),
      oracles::LiftedOutcome(map_outcome<long double>(outcome, [](S x) { return static_cast<long double>(x); })),
      yardstick);
  return comparison.holds ? 0 : least_that_is_shown * comparison.residual / comparison.allowed;
}

/// The spin of A from its change of velocity, in the body frame: w⁺ = w⁻ + R diag(1/I) Rᵀ (r × m Δv).
template <class S>
Outcome<S> with_spin_by_body_frame(const Collision& collision, Outcome<S> outcome) {
  const Contact<S> contact = make_contact<S>(collision);
  const Matrix3<S> rotation = rotation_matrix<S>(without_extreme_length<S>(collision.a.orientation));
  const Vector3<S> impulse = (outcome.a.velocity - contact.a.velocity) / contact.a.inverse_mass;
  const Vector3<S> torque = rotation.transpose() * contact.a.lever_arm.cross(impulse);
  outcome.a.angular_velocity =
      contact.a.angular_velocity + rotation * torque.cwiseQuotient(collision.a.principal_inertia.cast<S>());
  return outcome;
}

struct Missed {
  double worst = 0;
  int beyond_limit = 0;

  void add(double ulps) {
    worst = std::max(worst, ulps);
    beyond_limit += ulps > oracles::default_limit_ulps ? 1 : 0;
  }
};

template <class S>
class Slivers : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Slivers, Scalars);

TYPED_TEST(Slivers, LoseAngularMomentumInWorldCoordinatesAlone) {
  for (const double ratio : {8.0, 64.0, 512.0, 8192.0, 131072.0}) {
    Missed in_world;
    Missed in_body;
    const std::vector<Collision> cases = slivers(ratio, 1000);
    for (const Collision& collision : cases) {
      const auto outcome = frictionless(make_contact<TypeParam>(collision));
      in_world.add(missed_angular_momentum<TypeParam>(collision, outcome));
      in_body.add(missed_angular_momentum<TypeParam>(collision, with_spin_by_body_frame(collision, outcome)));
    }
    std::cout << "moments 1 : " << ratio << " to twice that, " << cases.size() << " bodies: worst " << in_world.worst
              << " ulps in world coordinates, beyond 32 in " << in_world.beyond_limit << "; worst " << in_body.worst
              << " in the body frame\n";
    EXPECT_LT(in_body.worst, 4) << ratio;
    if (ratio <= 64) {
      EXPECT_LT(in_world.worst, oracles::default_limit_ulps / 2) << ratio;
    }
    if (ratio >= 8192) {
      EXPECT_GT(in_world.beyond_limit, 20) << ratio;
    }
  }
}

/// The family `physical` ends where all solvers are sound.
TEST(PhysicalBodies, AreNoSlivers) {
  properties::Stream stream = properties::stream_from(96);
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const Collision c = properties::convex_bodies(stream).collision;
    largest = std::max({largest, ratio_of_moments(c.a), ratio_of_moments(c.b)});
  }
  EXPECT_LE(largest, 128);
  EXPECT_GT(largest, 64);
}

}  // namespace
}  // namespace carom::impulse
