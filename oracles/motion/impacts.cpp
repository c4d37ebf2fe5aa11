// SPDX-License-Identifier: BSL-1.0
#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/motion/impacts.hpp>

namespace carom::oracles {
namespace {

Enclosure power(const Enclosure& x, unsigned n) {
  Enclosure product(1);
  for (unsigned k = 0; k < n; ++k) {
    product *= x;
  }
  return product;
}

std::array<Known, 3> known(const Vector3<Enclosure>& x) {
  return {oracles::known(x[0]), oracles::known(x[1]), oracles::known(x[2])};
}

}  // namespace

Known impact_speed(const Fall& fall) {
  return known(sqrt(Enclosure(2) * Enclosure(fall.gravity) * Enclosure(fall.height)));
}

Known bounce_height(const Fall& fall, unsigned n) {
  return known(power(Enclosure(fall.restitution), 2 * n) * Enclosure(fall.height));
}

Known impact_time(const Fall& fall, unsigned n) {
  CAROM_EXPECTS(n >= 1);
  Enclosure falls(1);
  for (unsigned k = 1; k < n; ++k) {
    falls += Enclosure(2) * power(Enclosure(fall.restitution), k);
  }
  return known(falls * sqrt(Enclosure(2) * Enclosure(fall.height) / Enclosure(fall.gravity)));
}

AfterImpact after_impact(const WallImpact& impact) {
  const Vector3<Enclosure> n = impact.normal.cast<Enclosure>();
  const Vector3<Enclosure> v = impact.velocity.cast<Enclosure>();
  const Vector3<Enclosure> w = impact.angular_velocity.cast<Enclosure>();
  const Enclosure mass(impact.mass);
  const Enclosure inertia(impact.inertia);
  const Enclosure radius(impact.radius);
  const Vector3<Enclosure> lever = -radius * n;
  const Enclosure approach = n.dot(v);
  const Vector3<Enclosure> at_point = v + w.cross(lever);
  const Vector3<Enclosure> slip = at_point - n * n.dot(at_point);
  const Enclosure normal_impulse = -(Enclosure(1) + Enclosure(impact.restitution)) * mass * approach;
  const Enclosure mobility = Enclosure(1) / mass + radius * radius / inertia;
  const Enclosure slip_speed = sqrt(slip.dot(slip));
  const Enclosure most = Enclosure(impact.friction) * normal_impulse;
  const bool slides = (slip_speed / mobility - most).sign().value() > 0;
  const Enclosure against_slip = slides ? most / slip_speed : Enclosure(1) / mobility;
  const Vector3<Enclosure> impulse = n * normal_impulse - slip * against_slip;
  const Vector3<Enclosure> v_after = v + impulse / mass;
  const Vector3<Enclosure> w_after = w + lever.cross(impulse) / inertia;
  return {known(v_after), known(w_after), !slides};
}

}  // namespace carom::oracles
