// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <carom/collision/precision.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/trial/held.hpp>

namespace carom::properties {
namespace {

/// One ulp of the places that a lever arm is the difference of moves it by 2⁻¹⁰ of what it is compared with, at most;
/// the limit of 32 ulps by 2⁻⁵, of which the square, to which the yardstick is blind, is as much as one ulp makes.
constexpr double ulps_that_a_size_keeps = 0x1p+10;

double largest(const Vector3<double>& v) { return v.cwiseAbs().maxCoeff(); }

/// Whether sizes stay away from the ends of binary32, where a subject computes in it.
class Range {
 public:
  explicit Range(double unit_roundoff)
      : exponent_(unit_roundoff < carom::unit_roundoff(Precision::binary32) ? 0 : 120) {}

  /// Zero, or within the range.
  void require(double size) {
    int exponent = 0;
    std::frexp(size, &exponent);
    holds_ = holds_ && std::isfinite(size) && (size == 0 || std::abs(exponent) <= exponent_);
  }
  [[nodiscard]] bool holds() const { return holds_; }
  [[nodiscard]] bool has_ends() const { return exponent_ != 0; }

 private:
  int exponent_;  // 0: no end is near
  bool holds_ = true;
};

/// Of both bodies: Σ |N_i w_j r_k| over the terms of N·(w × r), Σ_j |∂(N·V)/∂x_j| |x_j|, and what they are roundings
/// of.
struct Roundings {
  double of_products = 0;
  double of_inputs = 0;
  double speed = 0;  // |N·V| / ‖N‖_∞
};

Roundings roundings_of_approach(const Collision& c) {
  Roundings roundings;
  Vector3<double> relative = Vector3<double>::Zero();
  double by_spins = 0;
  for (const Body* body : {&c.a, &c.b}) {
    const Vector3<double> r = oracles::lever_arm<double>(*body, c.point);
    const Vector3<double> w = body->angular_velocity;
    const Vector3<double> v = oracles::point_velocity<double>({body->velocity, w}, r);
    relative += body == &c.a ? v : Vector3<double>(-v);
    const Vector3<double> moments = r.cross(c.normal);
    const Vector3<double> of_places = c.normal.cross(w);
    by_spins += (body == &c.a ? 1 : -1) * moments.dot(w);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      roundings.of_products += std::abs(c.normal[i]) * (std::abs(w[j] * r[k]) + std::abs(w[k] * r[j]));
      roundings.of_inputs += std::abs(c.normal[i] * body->velocity[i]) + std::abs(moments[i] * w[i]) +
                             std::abs(of_places[i]) * (std::abs(c.point[i]) + std::abs(body->position[i]));
    }
  }
  roundings.of_inputs += c.normal.cwiseAbs().dot(relative.cwiseAbs());
  const double by_velocities = c.normal.dot(c.a.velocity - c.b.velocity);
  roundings.speed = std::abs(by_velocities + by_spins) / largest(c.normal);
  return roundings;
}

/// What any law makes of a contact.
void require_all(const Collision& collision, const Roundings& approach, double unit_roundoff, Range& range) {
  double lightest = 0;  // the smaller mass, by which the impulse is bounded
  double fastest = 0;
  for (const Body* body : {&collision.a, &collision.b}) {
    const double length = largest(oracles::lever_arm<double>(*body, collision.point));
    const double spin = largest(body->angular_velocity);
    fastest = std::max({fastest, largest(body->velocity), spin * length});
    range.require(largest(body->velocity));
    range.require(spin);
    if (body->immovable) {
      continue;
    }
    lightest = lightest == 0 ? body->mass : std::min(lightest, body->mass);
    range.require(body->mass);
    for (int i = 0; i < 3; ++i) {
      const double moment = body->principal_inertia[i];
      range.require(moment);
      range.require(length / moment);
      range.require(length / moment * length);
    }
  }
  // What the impulse is made of, or what rounding leaves of that, and what it is at most.
  const double rounding = unit_roundoff * approach.of_inputs / largest(collision.normal);
  for (const double speed : {std::max(approach.speed, rounding), fastest}) {
    range.require(speed);
    range.require(lightest * speed);
    for (const Body* body : {&collision.a, &collision.b}) {
      if (!body->immovable) {
        const double torque = lightest * speed * largest(oracles::lever_arm<double>(*body, collision.point));
        range.require(torque);
        range.require(torque / body->principal_inertia.minCoeff());
        range.require(torque / body->principal_inertia.maxCoeff());
      }
    }
  }
}

}  // namespace

std::string_view why_not_held(const Collision& collision, double unit_roundoff) {
  for (const Body* body : {&collision.a, &collision.b}) {
    const double length = largest(oracles::lever_arm<double>(*body, collision.point));
    const double lost =
        ulps_that_a_size_keeps * unit_roundoff * std::max(largest(collision.point), largest(body->position));
    if (length > 0 && lost > length) {
      return "the lever arm is lost in the places that it is the difference of";
    }
    if (!body->immovable && length > 0 && lost > std::sqrt(body->principal_inertia.minCoeff() / body->mass)) {
      return "a slender body is thinner than what its place and that of the contact are rounded by";
    }
  }
  const Roundings approach = roundings_of_approach(collision);
  if (approach.of_products > 32 * approach.of_inputs) {
    return "the rounding of w × r is more than inputs account for";
  }
  Range range(unit_roundoff);
  if (range.has_ends()) {
    require_all(collision, approach, unit_roundoff, range);
  }
  return range.holds() ? std::string_view() : "masses, moments, impulse or torque leave the range of numbers";
}

}  // namespace carom::properties
