// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/subjects/steppers.hpp>

namespace carom::subjects {
namespace {

constexpr double step = 1.0 / 60;
constexpr std::uint64_t steps = 120;
constexpr double time = step * static_cast<double>(steps);

/// Without contacts, each method has the velocity g t, and a position between those of the first and the last speed of
/// each step. So a fault of an adapter is not taken for one of its engine.
void expect_free_flight(const Stepper& stepper, const Shape& shape, const Vector3<double>& gravity) {
  SteppedBody body{shape, false, 2, {0.3, 0.4, 0.5}};
  body.state.position = {1, 2, 0};
  body.state.velocity = {3, 5, 0};
  body.state.angular_velocity = {0, 0, 2};
  const SteppingAnswer answer = stepper.open()({{gravity, 0.5, 0.3, false, {body}}, step, {steps}});
  ASSERT_TRUE(std::holds_alternative<SteppedStates>(answer));
  const BodyState& end = std::get<SteppedStates>(answer).states.at(0).at(0);
  const Vector3<double> velocity = body.state.velocity + time * gravity;
  const Vector3<double> position = body.state.position + time * (body.state.velocity + velocity) / 2;
  // Each step rounds a product and a sum. No number exceeds 40 m or 40 m/s.
  const double rounding = 2 * static_cast<double>(steps) * 40 * unit_roundoff(stepper.precision);
  EXPECT_LE((end.velocity - velocity).norm(), rounding);
  EXPECT_LE((end.position - position).norm(), gravity.norm() * step * time / 2 + rounding);
  EXPECT_LE((end.angular_velocity - body.state.angular_velocity).norm(), rounding);
}

TEST(LinkedSteppers, MoveABodyFreely) {
  for (const Stepper& stepper : all_steppers()) {
    if (stepper.absent.empty() && stepper.specification.empty()) {
      SCOPED_TRACE(stepper.name);
      for (const Vector3<double>& gravity : {Vector3<double>(0, 0, 0), Vector3<double>(1, -9.81, 0)}) {
        expect_free_flight(stepper, SphereShape{0.5}, gravity);
        expect_free_flight(stepper, BoxShape{{1, 0.6, 0.3}}, gravity);
      }
    }
  }
}

}  // namespace
}  // namespace carom::subjects
