// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/oracles/motion/impacts.hpp>
#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties {
namespace of_spin {

using namespace posing;

constexpr double radius = 0.5;
constexpr double approach = 2;  // [m/s]

/// A way to meet the wall.
struct Meeting {
  const char* name;
  double right, across;                             // velocity along the wall [m/s]
  double spin_across, spin_right = 0, spin_up = 0;  // [rad/s]
};

// A sphere sticks if its contact point slips with at most 7/2 μ (1 + ε) · 2 m/s = 3.15 m/s, and a disc with 2.7 m/s.
constexpr Meeting planar_meetings[] = {
    {"gripping", 1.5, 0, 0}, {"slipping", 6, 0, 0}, {"with backspin", 1, 0, -8}, {"with topspin", 1, 0, 12}};
constexpr Meeting spatial_meetings[] = {{"gripping, diagonal", 1.2, 1.6, 0, 0, 5},
                                        {"slipping, diagonal", 3, 4, 0, 0, 5}};

PosedRun posed(const Directions& d, double step, double share, const Meeting& meeting) {
  PosedRun run;
  SteppedBody flying = ball(d, radius);
  const oracles::WallImpact impact{
      flying.mass,
      rolling_inertia(d, flying),
      radius,
      0.5,
      0.3,
      d.up,
      meeting.right * d.right + meeting.across * d.across - approach * d.up,
      meeting.spin_right * d.right + meeting.spin_across * d.across + meeting.spin_up * d.up};
  flying.state.position = d.at(0, radius + approach * (4 + share) * step);
  flying.state.velocity = impact.velocity;
  flying.state.angular_velocity = impact.angular_velocity;
  run.stepping = {{{0, 0, 0}, impact.restitution, impact.friction, false, {floor(d), flying}}, step, {}};
  // A soft contact needs some time, and a speculative one some steps.
  run.stepping.report = report_at({std::max(0.1, 8 * step) + 5 * step}, step);
  run.read = [=, name = std::string(meeting.name)](const SteppedStates& states) {
    const BodyState& after = states.states.at(0)[1];
    const oracles::AfterImpact right = oracles::after_impact(impact);
    const double scale = impact.velocity.norm();
    std::vector<Reading> readings;
    const auto add = [&](const Vector3<double>& axis, const std::string& direction, bool is_moving, bool is_turning) {
      Eigen::Index i = 0;
      const double sign = axis[(axis.cwiseAbs().maxCoeff(&i), i)];
      const auto known = [&](const std::array<oracles::Known, 3>& all) {
        const oracles::Known& one = all[static_cast<std::size_t>(i)];
        return oracles::Known{sign * one.value, one.bound};
      };
      if (is_moving) {
        readings.push_back(reading("velocity " + direction + ", " + name, "m/s", axis.dot(after.velocity),
                                   known(right.velocity), scale, 0, scale));
      }
      if (is_turning) {
        readings.push_back(reading("spin about " + direction + ", " + name, "rad/s", axis.dot(after.angular_velocity),
                                   known(right.angular_velocity), scale / radius, 0, scale / radius));
      }
    };
    const bool is_diagonal = meeting.across != 0;
    add(d.up, "up", true, is_diagonal);
    add(d.right, "right", true, is_diagonal);
    add(d.across, "across", is_diagonal, true);
    return readings;
  };
  return run;
}

std::vector<PosedRun> runs(const Ladder& ladder, bool planar) {
  return at_each_phase(ladder, planar, [&](std::vector<PosedRun>& all, const Directions& d, double step, double share) {
    const auto add = [&](const Meeting& meeting) { all.push_back(posed(d, step, share, meeting)); };
    std::for_each(std::begin(planar_meetings), std::end(planar_meetings), add);
    if (!planar) {
      std::for_each(std::begin(spatial_meetings), std::end(spatial_meetings), add);
    }
  });
}

}  // namespace of_spin

Phenomenon spin() {
  return {
      "spin",
      1,
      "Does a ball leave an oblique bounce with the right spin?",
      "A solid sphere of 1 kg and R = 0.5 m meets a wall with 2 m/s along the normal, with ε = 1/2, μ = 0.3 and no "
      "gravity. Along the wall it has 1.5 m/s, 6 m/s, 1 m/s with a spin of −8 or 12 rad/s, or (1.2, 1.6) or (3, 4) m/s "
      "with a spin of 5 rad/s about the normal. The plane has a disc, and not the last two. The impact happens in the "
      "fifth step, at each phase of a step.",
      "The contact point slips with V_t, and λ_t = 1/m + R²/J (7/(2m) for the sphere, 3/m for the disc). It sticks if "
      "‖V_t‖ ≤ λ_t m μ (1 + ε) |V_n|, with the impulse −V_t/λ_t. Otherwise the impulse is μ F_n against V_t. Source: "
      "Coulomb's law; O. Walton and R. Braun, J. Rheol. 30 (1986).",
      "Velocity and spin 0.1 s after the impact, and at least 8 steps after it. Errors are relative to the speed "
      "before the impact, and to this speed divided by R.",
      "Nothing explains an error but rounding, because velocity and spin are the same at the end of a step as at the "
      "impact.",
      of_spin::runs};
}

}  // namespace carom::properties
