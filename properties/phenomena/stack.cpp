// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties {
namespace of_stack {

using namespace posing;

constexpr double duration = 10;

/// A pile of cubes with edges of 1 m. The masses are from the lowest to the highest.
PosedRun posed(const Directions& d, double step, const std::string& pile, const std::vector<double>& masses) {
  PosedRun run{{on_the_floor(d), step, report_at({duration}, step)}, {}};
  run.stepping.scene.friction = 0.5;
  std::vector<SteppedBody>& bodies = run.stepping.scene.bodies;
  for (const double mass : masses) {
    SteppedBody cube = block(d, 1, 1, 1, mass);
    cube.state.position = d.at(0, 0.5 + static_cast<double>(bodies.size() - 1));
    bodies.push_back(cube);
  }
  run.read = [d, bodies, name = ", " + pile](const SteppedStates& states) {
    double drift = 0;
    double turn = 0;
    double energy = 0;
    double scale = 0;  // the energy that frees each cube by its own height
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      const BodyState& now = states.states.at(0)[i];
      const Vector3<double> moved = now.position - bodies[i].state.position;
      drift = std::max(drift, (moved - d.up * d.up.dot(moved)).norm());
      turn = std::max(turn, turn_between(bodies[i].state.orientation, now.orientation));
      energy += bodies[i].mass * now.velocity.squaredNorm() / 2 +
                bodies[i].principal_inertia[0] * now.angular_velocity.squaredNorm() / 2;  // cubes have one J
      scale += bodies[i].mass * gravity;
    }
    const double top = d.up.dot(states.states.at(0).back().position - bodies.back().state.position);
    return std::vector{reading("drift" + name, "m", drift, {}, 1, 0, 0),
                       reading("turn" + name, "rad", turn, {}, 1, 0, 1),
                       reading("rise of the highest cube" + name, "m", top, {}, 1, 0, 5),
                       reading("kinetic energy" + name, "J", energy, {}, scale, 0, 0)};
  };
  return run;
}

std::vector<PosedRun> runs(const Ladder& ladder, bool planar) {
  Ladder longest{ladder.steps, 1};
  longest.steps.resize(std::min<std::size_t>(ladder.steps.size(), 5));
  return at_each_phase(longest, planar,
                       [&](std::vector<PosedRun>& all, const Directions& d, double step, double /*share*/) {
                         all.push_back(posed(d, step, "five equal cubes", {1, 1, 1, 1, 1}));
                         all.push_back(posed(d, step, "10 kg on 1 kg", {1, 10}));
                         all.push_back(posed(d, step, "100 kg on 1 kg", {1, 100}));
                       });
}

}  // namespace of_stack

Phenomenon stack() {
  return {
      "stack",
      1,
      "Does a stack stand?",
      "Cubes with edges of 1 m stand on each other and on a floor for 10 s, with ε = 0, μ = 1/2 and g = 9.81 m/s²: "
      "five of 1 kg, 10 kg on 1 kg, and 100 kg on 1 kg. The plane has squares.",
      "Nothing moves, because forces up at the corners carry each cube. Source: statics.",
      "The greatest drift and turn of a cube, the rise of the highest cube (negative if the stack sinks), and the "
      "kinetic energy, after 10 s. They are relative to an edge, a radian, and the energy m g of one edge. The five "
      "longest steps are measured.",
      "Nothing explains an error but rounding, because nothing moves.",
      of_stack::runs};
}

}  // namespace carom::properties
