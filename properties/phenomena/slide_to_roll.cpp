// SPDX-License-Identifier: BSL-1.0
#include <carom/oracles/motion/sliding.hpp>
#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties {
namespace of_slide_to_roll {

using namespace posing;

constexpr double radius = 0.5;
constexpr double in_slip = 0.1;  // slip ends at 0.194 s, or 0.227 s for the disc
constexpr double at_end = 2;

PosedRun posed(const Directions& d, double step) {
  PosedRun run{{on_the_floor(d), step, report_at({in_slip, at_end}, step)}, {}};
  SteppedBody rolling = ball(d, radius);
  const oracles::SlideToRoll roll{{2, 0.3, gravity}, rolling.mass, rolling_inertia(d, rolling), radius};
  rolling.state.position = d.at(0, radius);
  rolling.state.velocity = roll.slide.speed * d.right;
  run.stepping.scene.friction = roll.slide.friction;
  run.stepping.scene.bodies.push_back(rolling);
  run.read = [=, report = run.stepping.report](const SteppedStates& states) {
    const Reported middle = reported_at(states, report, in_slip, step);
    const Reported end = reported_at(states, report, at_end, step);
    const double v = roll.slide.speed;
    const double worth = roll.slide.friction * gravity * step;
    const double of_spin = worth * rolling.mass * radius * radius / roll.inertia;
    const double slip = oracles::rolling_time(roll).value;
    const oracles::Known distance = oracles::roll_distance(roll, end.time);
    const auto speed = [&](const Reported& now) { return d.right.dot(now.bodies[1].velocity); };
    const auto spin = [&](const Reported& now) { return radius * d.across.dot(now.bodies[1].angular_velocity); };
    return std::vector{
        reading("speed at 0.1 s", "m/s", speed(middle), oracles::roll_speed(roll, middle.time), v, worth, v),
        reading("spin times R at 0.1 s", "m/s", spin(middle), oracles::roll_spin(roll, middle.time), v, of_spin, v),
        reading("speed at 2 s", "m/s", speed(end), oracles::roll_speed(roll, end.time), v, 0, v),
        reading("spin times R at 2 s", "m/s", spin(end), oracles::roll_spin(roll, end.time), v, 0, v),
        reading("distance at 2 s", "m", d.right.dot(end.bodies[1].position), distance, distance.value, worth * slip,
                distance.value)};
  };
  return run;
}

std::vector<PosedRun> runs(const Ladder& ladder, bool planar) {
  return at_each_phase({ladder.steps, 1}, planar,
                       [&](std::vector<PosedRun>& all, const Directions& d, double step, double /*share*/) {
                         all.push_back(posed(d, step));
                       });
}

}  // namespace of_slide_to_roll

Phenomenon slide_to_roll() {
  return {
      "slide-to-roll",
      1,
      "Does a ball that slides end up rolling at 5/7 of its speed?",
      "A solid sphere of 1 kg and R = 0.5 m stands on a floor and starts at v₀ = 2 m/s without spin, with μ = 0.3, "
      "ε = 0 and g = 9.81 m/s². The plane has a disc.",
      "The sphere slips until 2v₀/(7μg), with the speed v₀ − μ g t and the spin 5μgt/(2R). Then it rolls at 5v₀/7 for "
      "ever. The disc slips until v₀/(3μg), and then rolls at 2v₀/3. Source: Coulomb's law of friction, and the "
      "angular momentum about the point of contact.",
      "Speed and spin at 0.1 s, in the slip, and at 2 s; the distance at 2 s. Errors of speeds are relative to v₀, "
      "and the error of the distance to the distance.",
      "One step's worth of friction is μ g h in speed in the slip, and this speed times the slip's duration in "
      "distance. The rolling speed does not depend on the step, because the angular momentum does not.",
      of_slide_to_roll::runs};
}

}  // namespace carom::properties
