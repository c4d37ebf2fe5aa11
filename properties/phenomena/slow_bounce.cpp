// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties {
namespace of_slow_bounce {

using namespace posing;

constexpr double radius = 0.5;
constexpr double restitution = 0.5;

PosedRun posed(const Directions& d, double step, double share, double speed) {
  PosedRun run;
  SteppedBody flying = ball(d, radius);
  flying.state.position = d.at(0, radius + speed * (4 + share) * step);
  flying.state.velocity = -speed * d.up;
  run.stepping = {{{0, 0, 0}, restitution, 0, false, {floor(d), flying}}, step, {}};
  // A soft contact needs some time, and a speculative one some steps.
  run.stepping.report = report_at({std::max(0.1, 8 * step) + 5 * step}, step);
  run.read = [=](const SteppedStates& states) {
    return std::vector{reading("speed after the impact, v = " + number(speed) + " m/s", "m/s",
                               d.up.dot(states.states.at(0)[1].velocity), {restitution * speed, 0}, restitution * speed,
                               0, speed)};
  };
  return run;
}

std::vector<PosedRun> runs(const Ladder& ladder, bool planar) {
  return at_each_phase(ladder, planar, [&](std::vector<PosedRun>& all, const Directions& d, double step, double share) {
    for (const double speed : {0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0}) {
      all.push_back(posed(d, step, share, speed));
    }
  });
}

}  // namespace of_slow_bounce

Phenomenon slow_bounce() {
  return {
      "slow-bounce",
      1,
      "Does a slow ball bounce, too?",
      "A sphere of 1 kg and R = 0.5 m meets a wall at 0.01, 0.03, 0.1, 0.3, 1, 3 and 10 m/s, head-on, with ε = 1/2, "
      "and without gravity and friction. It meets the wall in the fifth step, at each phase of a step. The plane has "
      "a disc.",
      "The sphere leaves at ε v at every speed. Source: Newton's law of restitution.",
      "The speed 0.1 s after the impact, and at least 8 steps after it. Errors are relative to ε v.",
      "Nothing explains an error but rounding, because the sphere is as fast at the end of a step as at the impact.",
      of_slow_bounce::runs};
}

}  // namespace carom::properties
