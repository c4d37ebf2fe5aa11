// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <numbers>

#include <carom/oracles/motion/impacts.hpp>
#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties {
namespace of_flat_landing {

using namespace posing;

constexpr double half_height = 0.25;

PosedRun posed(const Directions& d, double step, double share, double restitution, double degrees) {
  PosedRun run{{on_the_floor(d), step, {}}, {}};
  SteppedBody box = block(d, 1.2, 0.8, 2 * half_height, 1);
  const double half_angle = degrees * std::numbers::pi / 360;
  box.state.orientation[0] = std::cos(half_angle);
  box.state.orientation.tail<3>() = std::sin(half_angle) * d.up;
  // Below 1 m, the difference to the half height has no rounding.
  box.state.position = d.at(0, half_height + height_of_fall(0.6, step, share));
  run.stepping.scene.restitution = restitution;
  run.stepping.scene.friction = 0.3;
  run.stepping.scene.bodies.push_back(box);
  const oracles::Fall fall{d.up.dot(box.state.position) - half_height, gravity, restitution};
  const double speed = oracles::impact_speed(fall).value;
  const double apex = speed / gravity * (1 + restitution) + (restitution == 0 ? 0.1 : 0);
  run.stepping.report = report_at({apex}, step);
  const std::string at = ", ε = " + number(restitution) + (d.is_planar ? "" : ", turned by " + number(degrees) + "°");
  run.read = [=](const SteppedStates& states) {
    const BodyState& now = states.states.at(0)[1];
    const double z = d.up.dot(now.position) - half_height;
    const double v = d.up.dot(now.velocity);
    const Vector3<double> beside = now.position - d.up * d.up.dot(now.position);
    return std::vector{
        reading("height of the bounce" + at, "m", z + v * v / (2 * gravity), oracles::bounce_height(fall, 1),
                fall.height, speed * step, std::abs(z) + half_height + v * v / gravity),
        reading("turn" + at, "rad", turn_between(box.state.orientation, now.orientation), {}, 1, 0, 1),
        reading("drift" + at, "m", beside.norm(), {}, fall.height, 0, 0)};
  };
  return run;
}

std::vector<PosedRun> runs(const Ladder& ladder, bool planar) {
  return at_each_phase(ladder, planar, [&](std::vector<PosedRun>& all, const Directions& d, double step, double share) {
    for (const double restitution : {0.0, 0.5}) {
      all.push_back(posed(d, step, share, restitution, 0));
      if (!planar) {
        all.push_back(posed(d, step, share, restitution, 30));
      }
    }
  });
}

}  // namespace of_flat_landing

Phenomenon flat_landing() {
  return {
      "flat-landing",
      1,
      "Does a box that lands flat stay flat?",
      "A box of 1.2 m × 0.8 m × 0.5 m and 1 kg falls from about 0.6 m and lands flat, turned by 0° or 30° about the "
      "vertical, with ε = 0 or 1/2, μ = 0.3 and g = 9.81 m/s². The height of the fall puts the impact at each phase "
      "of a step. The plane has a rectangle, turned by 0°.",
      "By symmetry, the box does not turn and does not drift. It rebounds to ε² H. Source: Newton's law of "
      "restitution at each corner.",
      "The height z + v²/(2g) near the apex, or 0.1 s after the impact for ε = 0; turn and drift at this time. Errors "
      "of lengths are relative to H.",
      "One step's worth is v h in height, as for `bounce`. Nothing explains a turn or a drift.",
      of_flat_landing::runs};
}

}  // namespace carom::properties
