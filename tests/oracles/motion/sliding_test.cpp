// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/oracles/motion/sliding.hpp>

namespace carom::oracles {
namespace {

constexpr Slide slide{2, 0.3, 9.81};
constexpr double step = 0.001;

// The second derivation: the loss of energy is the work of friction, μ m g x.
TEST(Slide, LosesTheWorkOfFriction) {
  for (const std::uint64_t steps : {1U, 100U, 679U, 680U, 2000U}) {
    const Known v = slide_speed(slide, {step, steps});
    const Known x = slide_distance(slide, {step, steps});
    EXPECT_NEAR((slide.speed * slide.speed - v.value * v.value) / 2, slide.friction * slide.gravity * x.value,
                1e-15 * 4);
    EXPECT_LE(x.bound, 0x1p-53);
  }
  EXPECT_GT(slide_speed(slide, {step, 679}).value, 0);
  EXPECT_EQ(slide_speed(slide, {step, 680}).value, 0);
}

// The second derivation: the angular momentum about the point of contact, m v R + J w, is constant. The distance is the
// sum of the speeds, which is exact in the slip and in rolling, by the trapezoidal rule.
TEST(SlideToRoll, KeepsTheAngularMomentumAboutTheContact) {
  for (const double inertia : {0.1, 0.125}) {  // a sphere and a disc
    const SlideToRoll roll{slide, 1, inertia, 0.5};
    double distance = 0;
    for (std::uint64_t steps = 1; steps <= 2000; ++steps) {
      const double v = roll_speed(roll, {step, steps}).value;
      const double spin = roll_spin(roll, {step, steps}).value / roll.radius;
      EXPECT_NEAR(roll.mass * v * roll.radius + inertia * spin, roll.mass * slide.speed * roll.radius, 1e-15);
      distance += step * (v + roll_speed(roll, {step, steps - 1}).value) / 2;
      // The step in which rolling begins is off by at most μ g h²/8.
      EXPECT_NEAR(roll_distance(roll, {step, steps}).value, distance, 0.3 * 9.81 * step * step / 8 + 1e-12);
    }
    EXPECT_EQ(roll_speed(roll, {step, 2000}).value, roll_spin(roll, {step, 2000}).value);
  }
  EXPECT_NEAR(rolling_time({slide, 1, 0.1, 0.5}).value, 2 * 2 / (7 * 0.3 * 9.81), 1e-15);
  EXPECT_NEAR(roll_speed({slide, 1, 0.1, 0.5}, {step, 2000}).value, 10.0 / 7, 1e-15);
  EXPECT_NEAR(roll_speed({slide, 1, 0.125, 0.5}, {step, 2000}).value, 4.0 / 3, 1e-15);
}

TEST(Slope, HoldsUpToTheAngleOfFriction) {
  EXPECT_EQ(slope_acceleration(2.99, 10, 0.3).value, 0);
  EXPECT_NEAR(slope_acceleration(3.01, 10, 0.3).value, 0.01, 1e-15);
  EXPECT_LE(slope_acceleration(3.01, 10, 0.3).bound, 1e-18);
}

}  // namespace
}  // namespace carom::oracles
