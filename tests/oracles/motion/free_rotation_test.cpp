// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <gtest/gtest.h>

#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/motion/free_rotation.hpp>

namespace carom::oracles {
namespace {

const Vector3<double> moments{0.0375, 0.0908, 0.1133};

Vector3<double> angular_velocity(const FreeBody& body, double time) {
  const auto known = free_angular_velocity(body, time);
  return {known[0].value, known[1].value, known[2].value};
}

/// w in body axes and q.
using State = Eigen::Matrix<long double, 7, 1>;

State derivative(const State& x) {
  const Vector3<long double> j = moments.cast<long double>();
  const Vector3<long double> w = x.head<3>();
  const Quaternion<long double> q = x.tail<4>();
  State change;
  change.head<3>() = Vector3<long double>(j.cwiseProduct(w)).cross(w).cwiseQuotient(j);
  change[3] = -q.tail<3>().dot(w) / 2;
  change.tail<3>() = (q[0] * w + Vector3<long double>(q.tail<3>()).cross(w)) / 2;
  return change;
}

/// The second derivation: the method of Runge and Kutta, of order 4.
State integrated(const FreeBody& body, double time, int steps) {
  State x;
  x << body.angular_velocity.cast<long double>(), 1, 0, 0, 0;
  const long double h = static_cast<long double>(time) / steps;
  for (int k = 0; k < steps; ++k) {
    const State k1 = derivative(x);
    const State k2 = derivative(x + h / 2 * k1);
    const State k3 = derivative(x + h / 2 * k2);
    const State k4 = derivative(x + h * k3);
    x += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return x;
}

class FreeRotation : public testing::TestWithParam<Vector3<double>> {};

TEST_P(FreeRotation, IsThatOfEulersEquations) {
  const FreeBody body{moments, GetParam()};
  const State x = integrated(body, 10, 20000);
  EXPECT_LT((angular_velocity(body, 10) - x.head<3>().cast<double>()).norm(), 1e-9);
  const KnownAttitude attitude = free_attitude(body, 10);
  const Quaternion<double> q = x.tail<4>().cast<double>();
  EXPECT_LT((q - std::copysign(1.0, q.dot(attitude.value)) * attitude.value).norm(), 1e-9);
}

// Energy and angular momentum stay, to the bounds of the answers.
TEST_P(FreeRotation, KeepsEnergyAndAngularMomentum) {
  const FreeBody body{moments, GetParam()};
  const Vector3<double> momentum = moments.cwiseProduct(body.angular_velocity);
  const double energy = momentum.dot(body.angular_velocity);
  for (const double time : {0.0, 0.01, 1.0, 10.0}) {
    const auto known = free_angular_velocity(body, time);
    for (const Known& one : known) {
      EXPECT_LT(one.bound, 1e-15) << time;
    }
    const Vector3<double> w = angular_velocity(body, time);
    EXPECT_NEAR(moments.cwiseProduct(w).dot(w), energy, 1e-15 * 8);
    const KnownAttitude attitude = free_attitude(body, time);
    EXPECT_LT(attitude.bound, 1e-13) << time;
    const Vector3<double> now = turned<double>(attitude.value, moments.cwiseProduct(w));
    EXPECT_LT((now - momentum).norm(), attitude.bound * momentum.norm() + 1e-15) << time;
  }
}

// Each axis, in both directions, and each order of cn, sn and dn.
INSTANTIATE_TEST_SUITE_P(Axes, FreeRotation,
                         testing::Values(Vector3<double>{5, 0.1, 0.1}, Vector3<double>{-5, 0.1, -0.1},
                                         Vector3<double>{0.1, 5, 0.1}, Vector3<double>{-0.1, -5, 0.3},
                                         Vector3<double>{0.1, 0.1, 5}, Vector3<double>{0.1, -0.1, -5}));

}  // namespace
}  // namespace carom::oracles
