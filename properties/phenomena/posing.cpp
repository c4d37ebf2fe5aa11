// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/phenomena/posing.hpp>

namespace carom::properties::posing {

Vector3<double> Directions::at(double to_the_right, double upwards) const {
  return to_the_right * right + upwards * up;
}

Directions directions(bool planar) {
  return planar ? Directions{true, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}} : Directions{};
}

SteppedBody floor(const Directions& d) { return {HalfSpaceShape{d.up}, true}; }

SteppedBody ball(const Directions& d, double radius) {
  SteppedBody body{SphereShape{radius}};
  const double solid = 0.4 * body.mass * radius * radius;
  body.principal_inertia = {solid, solid, d.is_planar ? 0.5 * body.mass * radius * radius : solid};
  return body;
}

double rolling_inertia(const Directions& d, const SteppedBody& ball) {
  return ball.principal_inertia[d.is_planar ? 2 : 1];
}

SteppedBody block(const Directions& d, double along, double across, double high, double mass) {
  const Vector3<double> lengths =
      d.is_planar ? Vector3<double>{along, high, across} : Vector3<double>{along, across, high};
  SteppedBody body{BoxShape{lengths}, false, mass};
  const Vector3<double> squares = lengths.cwiseProduct(lengths);
  body.principal_inertia =
      mass / 12 * Vector3<double>{squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]};
  return body;
}

SteppedScene on_the_floor(const Directions& d) { return {-gravity * d.up, 0, 0, false, {floor(d)}}; }

std::uint64_t steps_to(double time, double step) {
  return static_cast<std::uint64_t>(std::max(1LL, std::llround(time / step)));
}

std::vector<std::uint64_t> report_at(const std::vector<double>& times, double step) {
  std::vector<std::uint64_t> report(times.size());
  std::transform(times.begin(), times.end(), report.begin(), [&](double time) { return steps_to(time, step); });
  std::sort(report.begin(), report.end());
  report.erase(std::unique(report.begin(), report.end()), report.end());
  return report;
}

Reported reported_at(const SteppedStates& states, const std::vector<std::uint64_t>& report, double time, double step) {
  const std::uint64_t steps = steps_to(time, step);
  const auto place = std::lower_bound(report.begin(), report.end(), steps) - report.begin();
  return {{step, steps}, states.states.at(static_cast<std::size_t>(place))};
}

double height_of_fall(double height, double step, double share) {
  const double whole = std::floor(std::sqrt(2 * height / gravity) / step);
  const double time = (whole + share) * step;
  return gravity * time * time / 2;
}

double rounding_of(double size) { return 8 * std::numeric_limits<double>::epsilon() / 2 * std::abs(size); }

Reading reading(std::string what, std::string unit, double measured, const oracles::Known& right, double scale,
                double step_worth, double size) {
  return {std::move(what), std::move(unit), measured, right.value, right.bound + rounding_of(size), scale, step_worth};
}

double turn_between(const Quaternion<double>& from, const Quaternion<double>& to) {
  const double w = from.dot(to);
  const Vector3<double> u = from[0] * to.tail<3>() - to[0] * from.tail<3>() -
                            Vector3<double>(from.tail<3>()).cross(Vector3<double>(to.tail<3>()));
  return 2 * std::atan2(u.norm(), std::abs(w));
}

std::string number(double x) { return fmt::format("{}", x); }

}  // namespace carom::properties::posing
