// SPDX-License-Identifier: BSL-1.0
#include <carom/oracles/motion/sliding.hpp>
#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties {
namespace of_slide {

using namespace posing;

constexpr oracles::Slide the_slide{2, 0.3, gravity};
constexpr double half_way = 0.34;  // v₀/(μg) is 0.680 s
constexpr double at_rest = 1.2;

PosedRun posed(const Directions& d, double step) {
  PosedRun run{{on_the_floor(d), step, report_at({half_way, at_rest}, step)}, {}};
  SteppedBody box = block(d, 1, 1, 0.5, 1);
  box.state.position = d.at(0, 0.25);
  box.state.velocity = the_slide.speed * d.right;
  run.stepping.scene.friction = the_slide.friction;
  run.stepping.scene.bodies.push_back(box);
  run.read = [=, report = run.stepping.report](const SteppedStates& states) {
    const Reported middle = reported_at(states, report, half_way, step);
    const Reported end = reported_at(states, report, at_rest, step);
    const BodyState& last = end.bodies[1];
    const double worth = the_slide.friction * gravity * step;
    const oracles::Known distance = oracles::slide_distance(the_slide, end.time);
    return std::vector{
        reading("speed at 0.34 s", "m/s", d.right.dot(middle.bodies[1].velocity),
                oracles::slide_speed(the_slide, middle.time), the_slide.speed, worth, the_slide.speed),
        reading("distance at 1.2 s", "m", d.right.dot(last.position), distance, distance.value, step * the_slide.speed,
                distance.value),
        reading("speed at 1.2 s", "m/s", last.velocity.norm(), oracles::slide_speed(the_slide, end.time),
                the_slide.speed, 0, the_slide.speed),
        reading("turn at 1.2 s", "rad", turn_between(box.state.orientation, last.orientation), {}, 1, 0, 1)};
  };
  return run;
}

std::vector<PosedRun> runs(const Ladder& ladder, bool planar) {
  return at_each_phase({ladder.steps, 1}, planar,
                       [&](std::vector<PosedRun>& all, const Directions& d, double step, double /*share*/) {
                         all.push_back(posed(d, step));
                       });
}

}  // namespace of_slide

Phenomenon slide() {
  return {
      "slide",
      1,
      "Does a box that slides stop where it should, without turning?",
      "A box of 1 m × 1 m × 0.5 m and 1 kg stands on a floor and starts at 2 m/s, with μ = 0.3, ε = 0 and "
      "g = 9.81 m/s². It does not tip, because μ times its half height is less than its half length.",
      "The speed is v₀ − μ g t. The box stops after v₀/(μ g), at v₀²/(2 μ g), and does not turn. Source: Coulomb's "
      "law of friction.",
      "The speed halfway at 0.34 s; distance, speed and turn at 1.2 s, after the stop. Errors of speeds are relative "
      "to v₀, and the error of the distance to the distance.",
      "One step's worth of friction is μ g h in speed, and this speed times v₀/(μ g) in distance. Nothing explains a "
      "turn or a creep.",
      of_slide::runs};
}

}  // namespace carom::properties
