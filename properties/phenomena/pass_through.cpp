// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties {
namespace of_pass_through {

using namespace posing;

constexpr double radius = 0.1;
constexpr double diameter = 2 * radius;
constexpr double thickness = radius;  // of the wall
constexpr double restitution = 0.5;

struct Shot {
  double diameters;  // a step
  bool at_wall;      // or at another sphere
  bool is_continuous;
};

PosedRun posed(const Directions& d, double step, double share, const Shot& shot) {
  PosedRun run;
  const double speed = shot.diameters * diameter / step;
  const double path = shot.diameters * diameter * (3 + share);
  SteppedBody shell = ball(d, radius);
  shell.state.velocity = speed * d.right;
  SteppedBody target = ball(d, radius);
  if (shot.at_wall) {
    shell.state.position = -(path + radius) * d.right;
    target = block(d, thickness, 4, 4, 1);
    target.is_fixed = true;
    target.state.position = thickness / 2 * d.right;
  } else {
    // Both have half the speed. They meet in the middle.
    shell.state.velocity /= 2;
    shell.state.position = -(path / 2 + radius) * d.right;
    target.state.velocity = -shell.state.velocity;
    target.state.position = -shell.state.position;
  }
  run.stepping = {{{0, 0, 0}, restitution, 0, shot.is_continuous, {target, shell}}, step, {}};
  // A speculative contact needs some steps, and a soft one some time.
  run.stepping.report = report_at({std::max(0.02, 6 * step) + 4 * step}, step);
  const std::string at = (shot.at_wall ? ", wall, " : ", sphere, ") + number(shot.diameters) + " diameters a step" +
                         (shot.is_continuous ? ", continuous" : "");
  run.read = [d, at, at_wall = shot.at_wall, before = d.right.dot(shell.state.velocity)](const SteppedStates& states) {
    const std::vector<BodyState>& now = states.states.at(0);
    // The far face of the wall, or the centre of the other sphere.
    const double beyond = d.right.dot(now[1].position) - (at_wall ? thickness : d.right.dot(now[0].position));
    return std::vector{reading("passes" + at, "", beyond > 0 ? 1 : 0, {}, 1, 0, 0),
                       reading("velocity after" + at, "m/s", d.right.dot(now[1].velocity), {-restitution * before, 0},
                               before, 0, before)};
  };
  return run;
}

std::vector<PosedRun> runs(const Ladder& ladder, bool planar) {
  // The answer depends on the diameters a step and hardly on the step.
  Ladder longest = ladder;
  longest.steps.resize(std::min<std::size_t>(ladder.steps.size(), 2));
  return at_each_phase(longest, planar,
                       [&](std::vector<PosedRun>& all, const Directions& d, double step, double share) {
                         for (const double diameters : {0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0}) {
                           for (const bool at_wall : {true, false}) {
                             for (const bool is_continuous : {false, true}) {
                               all.push_back(posed(d, step, share, {diameters, at_wall, is_continuous}));
                             }
                           }
                         }
                       });
}

}  // namespace of_pass_through

Phenomenon pass_through() {
  return {
      "pass-through",
      1,
      "Does a fast ball pass through a thin wall?",
      "A sphere of 1 kg and R = 0.1 m flies at a fixed wall that is 0.1 m thick, or at an equal sphere that flies as "
      "fast towards it, with ε = 1/2 and without gravity and friction. In a step, they approach by 1/4, 1/2, 1, … 64 "
      "diameters. They meet in the fourth step, at each phase. Continuous detection is off and on. The two longest "
      "steps are measured. The plane has discs.",
      "The sphere does not pass, and leaves at −ε v. Source: Newton's law of restitution.",
      "The sphere's centre is beyond the far face of the wall or the other sphere's centre (1) or not (0). Its "
      "velocity "
      "is relative to the velocity before. Both are read 0.02 s after the impact and at least 6 steps after it.",
      "Nothing explains an error but rounding, because the sphere is as fast at the end of a step as at the impact.",
      of_pass_through::runs};
}

}  // namespace carom::properties
