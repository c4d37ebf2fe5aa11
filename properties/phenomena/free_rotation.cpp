// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>

#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/motion/free_rotation.hpp>
#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties {
namespace of_free_rotation {

using namespace posing;

constexpr double early = 1;
constexpr double late = 10;
constexpr std::array axis_names{"long", "middle", "short"};

SteppedBody brick(Eigen::Index axis) {
  SteppedBody body = block(directions(false), 1, 0.6, 0.3, 1);
  body.state.angular_velocity = {0.1, 0.1, 0.1};
  body.state.angular_velocity[axis] = 5;
  return body;
}

/// The exact motion of a brick that turns about an axis.
struct KnownTurn {
  oracles::FreeBody body;
  oracles::KnownAttitude early_attitude;
  oracles::KnownAttitude late_attitude;
  double greatest_torque = 0;        // ‖w × J w‖, which changes J w in body axes [N m]
  double greatest_acceleration = 0;  // ‖J⁻¹ (w × J w)‖ [rad/s²]

  explicit KnownTurn(Eigen::Index axis)
      : body{brick(axis).principal_inertia, brick(axis).state.angular_velocity},
        early_attitude(oracles::free_attitude(body, early)),
        late_attitude(oracles::free_attitude(body, late)) {
    for (int k = 0; k < 200; ++k) {
      const auto known = oracles::free_angular_velocity(body, k * late / 200);
      const Vector3<double> w{known[0].value, known[1].value, known[2].value};
      const Vector3<double> torque = w.cross(body.principal_inertia.cwiseProduct(w));
      greatest_torque = std::max(greatest_torque, torque.norm());
      greatest_acceleration = std::max(greatest_acceleration, torque.cwiseQuotient(body.principal_inertia).norm());
    }
  }

  /// Most steps divide the two times. Another time takes a tenth of a second.
  [[nodiscard]] oracles::KnownAttitude attitude(double time) const {
    return time == early ? early_attitude : time == late ? late_attitude : oracles::free_attitude(body, time);
  }
};

const KnownTurn& known_turn(Eigen::Index axis) {
  static const std::array<KnownTurn, 3> known{KnownTurn(0), KnownTurn(1), KnownTurn(2)};
  return known[static_cast<std::size_t>(axis)];
}

/// J w in world axes, with the body's attitude.
Vector3<double> momentum(const SteppedBody& body, const BodyState& state) {
  const Vector3<double> in_body =
      oracles::turned<double>(oracles::conjugate<double>(state.orientation), state.angular_velocity);
  return oracles::turned<double>(state.orientation, body.principal_inertia.cwiseProduct(in_body));
}

PosedRun posed(double step, Eigen::Index axis) {
  const SteppedBody body = brick(axis);
  PosedRun run{{{{0, 0, 0}, 0, 0, false, {body}}, step, report_at({early, late}, step)}, {}};
  run.read = [=, report = run.stepping.report](const SteppedStates& states) {
    const Vector3<double> before = momentum(body, body.state);
    const double energy = before.dot(body.state.angular_velocity) / 2;
    const KnownTurn& known = known_turn(axis);
    const double of_momentum = known.greatest_torque * step;
    const std::string name = std::string(", about the ") + axis_names[static_cast<std::size_t>(axis)] + " axis";
    const auto attitude_at = [&](const Reported& now, const char* when) {
      const oracles::KnownAttitude right = known.attitude(now.seconds());
      // The time is rounded, too.
      return reading("error of the attitude" + std::string(when) + name, "rad",
                     turn_between(right.value, now.bodies[0].orientation), {0, right.bound}, 1,
                     known.greatest_acceleration * step * now.seconds(),
                     1 + body.state.angular_velocity.norm() * now.seconds());
    };
    const Reported end = reported_at(states, report, late, step);
    const Vector3<double> after = momentum(body, end.bodies[0]);
    std::vector readings{
        attitude_at(reported_at(states, report, early, step), " at 1 s"),
        reading("energy at 10 s" + name, "J", after.dot(end.bodies[0].angular_velocity) / 2,
                {energy, rounding_of(energy)}, energy, of_momentum * body.state.angular_velocity.norm(), energy),
        reading("change of the angular momentum at 10 s" + name, "kg m²/s", (after - before).norm(), {}, before.norm(),
                of_momentum, 4 * before.norm())};
    // About the middle axis, an error grows by e^2.7 a second, so the attitude at 10 s tells engines apart no more.
    if (axis != 1) {
      readings.push_back(attitude_at(end, " at 10 s"));
    }
    return readings;
  };
  return run;
}

std::vector<PosedRun> runs(const Ladder& ladder, bool planar) {
  return at_each_phase({ladder.steps, 1}, planar,
                       [&](std::vector<PosedRun>& all, const Directions& d, double step, double /*share*/) {
                         for (Eigen::Index axis = 0; axis < 3 && !d.is_planar; ++axis) {
                           all.push_back(posed(step, axis));
                         }
                       });
}

}  // namespace of_free_rotation

Phenomenon free_rotation() {
  return {
      "free-rotation",
      1,
      "Does a brick that turns freely tumble as it should?",
      "A brick of 1 m × 0.6 m × 0.3 m and 1 kg turns without gravity and contacts for 10 s, with 5 rad/s about its "
      "long, middle or short axis and 0.1 rad/s about each other axis.",
      "Energy and angular momentum stay. Euler's equations J₁w₁' = (J₂ − J₃)w₂w₃, … have the solution w₁, w₂, w₃ in "
      "multiples of cn, sn and dn, Jacobi's elliptic functions; the attitude follows by q' = ½ q w. Source: L. Landau, "
      "E. Lifshitz, Mechanics, §37.",
      "The angle between the attitude and the exact one, at 1 s, and about the stable axes at 10 s; energy and angular "
      "momentum at 10 s, relative to the first ones.",
      "One step's worth is the greatest w × J w times h in angular momentum, and the greatest w' times h times the "
      "time in attitude.",
      of_free_rotation::runs};
}

}  // namespace carom::properties
