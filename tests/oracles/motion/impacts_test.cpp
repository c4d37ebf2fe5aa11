// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <carom/oracles/motion/impacts.hpp>

namespace carom::oracles {
namespace {

Vector3<double> values(const std::array<Known, 3>& known) { return {known[0].value, known[1].value, known[2].value}; }

// The second derivation: from impact to impact, by the energy and the time of each flight in long double.
TEST(Fall, FliesFromImpactToImpact) {
  for (const double restitution : {0.0, 0.25, 0.7, 1.0}) {
    const Fall fall{0.93, 9.81, restitution};
    const long double g = 9.81;
    long double speed = std::sqrt(2 * g * static_cast<long double>(fall.height));
    long double time = speed / g;
    EXPECT_NEAR(impact_speed(fall).value, static_cast<double>(speed), 1e-15);
    for (unsigned n = 1; n <= 20; ++n) {
      const Known known_time = impact_time(fall, n);
      EXPECT_NEAR(known_time.value, static_cast<double>(time), known_time.bound + 1e-15 * known_time.value);
      speed *= static_cast<long double>(restitution);
      time += 2 * speed / g;
      const Known height = bounce_height(fall, n);
      EXPECT_NEAR(height.value, static_cast<double>(speed * speed / (2 * g)), 1e-15 * height.value);
      EXPECT_LE(height.bound, 0x1p-53 * height.value + 1e-300);
    }
  }
}

// The second derivation: the balances of both momenta, Newton's law, and either rest or friction on the cone.
TEST(WallImpact, KeepsTheLawsOfImpact) {
  WallImpact impact{1.7, 0.31, 0.6, 0.4, 0.3, {0, 0, 1}, {3, -1, -2}, {0.5, 4, 1}};
  for (const double friction : {0.0, 0.1, 0.3, 3.0}) {
    for (const Vector3<double>& axis : {Vector3<double>{0, 0, 1}, Vector3<double>{0, 0, -1}}) {
      impact.friction = friction;
      impact.normal = axis;
      impact.velocity[2] = -2 * axis[2];
      const AfterImpact after = after_impact(impact);
      const Vector3<double> v = values(after.velocity);
      const Vector3<double> w = values(after.angular_velocity);
      const Vector3<double> impulse = impact.mass * (v - impact.velocity);
      const Vector3<double> arm = -impact.radius * axis;
      const Vector3<double> torque = impact.inertia * (w - impact.angular_velocity);
      EXPECT_LT((torque - arm.cross(impulse)).norm(), 1e-14);
      EXPECT_NEAR(axis.dot(v), 0.8, 1e-15);
      const auto slip = [&](const Vector3<double>& velocity, const Vector3<double>& spin) {
        const Vector3<double> at_point = velocity + spin.cross(arm);
        return Vector3<double>(at_point - axis * axis.dot(at_point));
      };
      const Vector3<double> before = slip(impact.velocity, impact.angular_velocity);
      const Vector3<double> along = impulse - axis * axis.dot(impulse);
      // The contact point slips with 0.9 m/s on one side, and with 5.6 m/s on the other.
      EXPECT_EQ(after.sticks, friction > (axis[2] > 0 ? 0.2 : 1));
      if (after.sticks) {
        EXPECT_LT(slip(v, w).norm(), 1e-14);
        EXPECT_LT(along.norm(), friction * axis.dot(impulse));
      } else {
        EXPECT_NEAR(along.norm(), friction * axis.dot(impulse), 1e-14);
        EXPECT_NEAR(along.dot(before), -along.norm() * before.norm(), 1e-13);
        EXPECT_GT(slip(v, w).dot(before), 0);
      }
    }
  }
}

}  // namespace
}  // namespace carom::oracles
