// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <numbers>

#include <carom/oracles/motion/sliding.hpp>
#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties {
namespace of_stick {

using namespace posing;

constexpr double from = 0.5;  // the first time of the measurement, after the start has settled
constexpr double to = 1;

PosedRun posed(const Directions& d, double step, double friction, double degrees) {
  PosedRun run{{on_the_floor(d), step, report_at({from, to}, step)}, {}};
  const double angle = degrees * std::numbers::pi / 180;
  const double along = gravity * std::sin(angle);
  const double into = gravity * std::cos(angle);
  SteppedBody box = block(d, 1, 1, 0.5, 1);
  box.state.position = d.at(0, 0.25);
  run.stepping.scene.gravity = d.at(along, -into);
  run.stepping.scene.friction = friction;
  run.stepping.scene.bodies.push_back(box);
  const oracles::Known right = oracles::slope_acceleration(along, into, friction);
  const std::string at = ", μ = " + number(friction) + ", θ = " + number(degrees) + "°";
  run.read = [=, report = run.stepping.report](const SteppedStates& states) {
    const Reported first = reported_at(states, report, from, step);
    const Reported last = reported_at(states, report, to, step);
    const BodyState& before = first.bodies[1];
    const BodyState& after = last.bodies[1];
    const double duration = last.seconds() - first.seconds();
    if (right.value > 0) {
      const double gained = d.right.dot(after.velocity - before.velocity);
      return std::vector{reading("acceleration" + at, "m/s²", gained / duration, right, along, 0,
                                 d.right.dot(after.velocity) / duration)};
    }
    // The scale is the speed that the box would gain in a second without friction.
    return std::vector{reading("speed of creep" + at, "m/s", (after.position - before.position).norm() / duration,
                               right, along, 0, after.position.norm() / duration)};
  };
  return run;
}

std::vector<PosedRun> runs(const Ladder& ladder, bool planar) {
  return at_each_phase({ladder.steps, 1}, planar,
                       [&](std::vector<PosedRun>& all, const Directions& d, double step, double /*share*/) {
                         for (const double friction : {0.2, 0.4, 0.8}) {
                           for (const double degrees : {10.0, 20.0, 30.0, 40.0}) {
                             all.push_back(posed(d, step, friction, degrees));
                           }
                         }
                       });
}

}  // namespace of_stick

Phenomenon stick() {
  return {
      "stick",
      1,
      "Does a box on a slope rest if it should, and slide as fast as it should?",
      "A box of 1 m × 1 m × 0.5 m and 1 kg stands on a floor. Gravity, 9.81 m/s², is tilted by θ = 10°, 20°, 30° or "
      "40°, so that the floor is a slope. μ is 0.2, 0.4 or 0.8, and ε = 0.",
      "The box rests if tan θ ≤ μ. Otherwise its acceleration is g (sin θ − μ cos θ). Source: Coulomb's law of "
      "friction.",
      "Between 0.5 s and 1 s: the speed of creep if the box should rest, otherwise the acceleration. Errors are "
      "relative to g sin θ, in a second.",
      "Nothing explains an error but rounding, because the acceleration is constant.",
      of_stick::runs};
}

}  // namespace carom::properties
