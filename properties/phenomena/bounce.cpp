// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/oracles/motion/impacts.hpp>
#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties {
namespace of_bounce {

using namespace posing;

constexpr double radius = 0.5;

/// The time of a rise to the height [s].
double rise(double height) { return std::sqrt(2 * std::max(height, 0.0) / gravity); }

/// The n-th bounce of a fall: its times, and the errors that one step's worth at each impact explains.
struct Bounce {
  unsigned n;
  double impact;  // [s]
  double apex;    // [s]
  double height_worth;
  double time_worth;
};

Bounce bounce(const oracles::Fall& fall, unsigned n, double step) {
  double v = oracles::impact_speed(fall).value;  // before impact k
  double speed_error = 0;
  Bounce b{n, v / fall.gravity, 0, 0, step};
  for (unsigned k = 1;; ++k) {
    // An engine is off by g h in speed, or by v h in place. Both are worth v h in height.
    b.height_worth += v * step;
    v *= fall.restitution;
    speed_error = fall.restitution * (speed_error + fall.gravity * step);
    if (k == n) {
      break;
    }
    b.impact += 2 * v / fall.gravity;
    b.time_worth += 2 * speed_error / fall.gravity + step;
  }
  b.apex = b.impact + v / fall.gravity;
  // The time of an impact is read off the height after it: t = apex − √(2 height / g).
  b.time_worth += speed_error / fall.gravity + (v > 0 ? b.height_worth / v : 0);
  return b;
}

/// The size of a number whose 8 roundings an engine may lose in height if it solves for the time of an impact. The gap
/// z + v t − g t²/2 has terms of up to R + H, 2 H and H. Its coefficients and its value have 8 roundings of each. Both
/// count twice, because a bound of the root's error is 2 |gap| / |slope|.
double size_of_search(const oracles::Fall& fall) { return 4 * (radius + 4 * fall.height); }

std::vector<Reading> read(const oracles::Fall& fall, const std::vector<Bounce>& bounces, const Directions& d,
                          const std::vector<std::uint64_t>& report, double step, const SteppedStates& states) {
  std::vector<Reading> readings;
  const std::string at = ", ε = " + number(fall.restitution);
  for (const Bounce& b : bounces) {
    const Reported now = reported_at(states, report, b.apex, step);
    const double z = d.up.dot(now.bodies[1].position) - radius;
    const double v = d.up.dot(now.bodies[1].velocity);
    const double height = z + v * v / (2 * fall.gravity);
    const oracles::Known right = oracles::bounce_height(fall, b.n);
    const std::string name = "bounce " + std::to_string(b.n) + at;
    readings.push_back(reading("height of " + name, "m", height, right, fall.height, b.height_worth,
                               std::abs(z) + radius + v * v / fall.gravity + size_of_search(fall)));
    // A low bounce shows no time.
    if (fall.restitution > 0 && (b.n == 1 || (b.n == 5 && fall.restitution > 0.7))) {
      // A height that is off by e moves an impact, and the rise after it, by up to e / v. The last v is the least.
      const double slowest = fall.gravity * rise(right.value);
      readings.push_back(reading("time of impact of " + name, "s", now.seconds() + v / fall.gravity - rise(height),
                                 oracles::impact_time(fall, b.n), oracles::impact_time(fall, 1).value, b.time_worth,
                                 now.seconds() + (radius + right.value + 2 * b.n * size_of_search(fall)) / slowest));
    }
  }
  return readings;
}

PosedRun posed(const Directions& d, double step, double share, double restitution, bool is_long) {
  PosedRun run{{on_the_floor(d), step, {}}, {}};
  SteppedBody falling = ball(d, radius);
  falling.state.position = d.at(0, radius + height_of_fall(1, step, share));
  run.stepping.scene.restitution = restitution;
  run.stepping.scene.bodies.push_back(falling);
  // The difference is exact, so the fall is that of the posed position.
  const oracles::Fall fall{d.up.dot(falling.state.position) - radius, gravity, restitution};
  std::vector<Bounce> bounces;
  std::vector<double> times;
  for (const unsigned n : {1U, 2U, 3U, 4U, 5U, 20U}) {
    // A rise of less than half a step is reported nowhere: the state nearest the apex lies in another bounce.
    const bool is_reported = rise(oracles::bounce_height(fall, n).value) >= step / 2;
    if (restitution > 0 ? is_reported && (n < 20 || is_long) : n == 1) {
      bounces.push_back(bounce(fall, n, step));
      bounces.back().apex += restitution > 0 ? 0 : 0.1;  // it lies on the floor
      times.push_back(bounces.back().apex);
    }
  }
  run.stepping.report = report_at(times, step);
  run.read = [=, report = run.stepping.report](const SteppedStates& states) {
    return read(fall, bounces, d, report, step, states);
  };
  return run;
}

std::vector<PosedRun> runs(const Ladder& ladder, bool planar) {
  const double shortest_long = ladder.steps[std::min<std::size_t>(ladder.steps.size(), 3) - 1];
  return at_each_phase(ladder, planar, [&](std::vector<PosedRun>& all, const Directions& d, double step, double share) {
    for (const double restitution : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      all.push_back(posed(d, step, share, restitution, restitution == 1 && step >= shortest_long));
    }
  });
}

}  // namespace of_bounce

Phenomenon bounce() {
  return {"bounce",
          2,
          "Does a ball bounce as high as it should?",
          "A sphere of 1 kg and R = 0.5 m falls from about 1 m above a floor, with g = 9.81 m/s² and without friction. "
          "The restitution ε is 0, 1/4, 1/2, 3/4 or 1. The height of the fall puts the first impact at each phase of a "
          "step. The plane has a disc.",
          "Bounce n reaches the height ε²ⁿ H. With t₁ = √(2H/g), impact n is at t₁ (1 + 2ε + … + 2εⁿ⁻¹). Source: "
          "Newton's law of restitution, and the conservation of energy in free fall.",
          "The height z + v²/(2g) near the apex of bounces 1 to 5, and of bounce 20 for ε = 1 at the three longest "
          "steps; the times of impacts 1 and 5. A bounce that rises for less than half a step is left out. Errors of "
          "heights are relative to H, and errors of times to t₁.",
          "An engine that looks for contacts at the ends of steps finds an impact up to a step late. It is then off by "
          "up to g h in speed or v h in place. Both are worth v h in height.",
          of_bounce::runs};
}

}  // namespace carom::properties
