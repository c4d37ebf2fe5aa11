// SPDX-License-Identifier: BSL-1.0
#include "known_sweeps.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/models/models.hpp>

#include "known_collisions.hpp"

namespace carom::unit {
namespace {

/// A friction coefficient for which the impulse of `rough` lies on the surface of the friction cone, up to rounding.
double friction_on_surface(Collision c) {
  double outside = 0;
  double inside = 64;
  for (int i = 0; i < 60; ++i) {
    c.friction = (outside + inside) / 2;
    (oracles::ExactCase(c).branch(Law::rough) == oracles::Branch::inside_cone ? inside : outside) = c.friction;
  }
  return inside;
}

/// A collision with N·D > 0, whose μ makes the divisor ‖N × D‖ − μ N·D of `rough` 0, up to rounding (impulse/rough.hpp
/// defines D). The sign of N·D depends on the direction of the slip.
Collision with_zero_divisor() {
  for (const double sign : {1.0, -1.0}) {
    Collision c = plain_collision();
    c.a.velocity += sign * Vector3<double>(16, -2, 0);
    const Vector3<double> d = oracles::detail::RoughImpulses<double>(c, nullptr).difference();
    if (c.normal.dot(d) > 0) {
      c.friction = c.normal.cross(d).norm() / c.normal.dot(d);
      return c;
    }
  }
  throw std::logic_error("N·D is negative for both directions");
}

}  // namespace

std::vector<Sweep> sweeps() {
  const Collision zero_divisor = with_zero_divisor();
  const double surface = friction_on_surface(plain_collision());
  const auto sweep = [](std::string name, int count, const std::function<void(Collision&, int)>& change) {
    return Sweep{std::move(name), count, [change](int k) {
                   Collision c = plain_collision();
                   change(c, k);
                   return c;
                 }};
  };
  std::vector<Sweep> all{
      sweep("distance", 56,
            [](Collision& c, int k) {
              for (Vector3<double>* place : {&c.a.position, &c.b.position, &c.point}) {
                *place += std::ldexp(1.0, k) * Vector3<double>(1, -0.25, 0);
              }
            }),
      sweep("needle", 60, [](Collision& c, int k) { c.a.principal_inertia[0] = std::ldexp(0.5, -2 * k); }),
      sweep("mass of A", 70, [](Collision& c, int k) { c.a.mass = std::ldexp(2.0, k); }),
      sweep("moments of B", 60, [](Collision& c, int k) { c.b.principal_inertia *= std::ldexp(1.0, -2 * k); }),
      sweep("lever arm of A", 60,
            [](Collision& c, int k) { c.a.position = c.point + std::ldexp(1.0, -k) * Vector3<double>(1, 0.25, -0.5); }),
      sweep("spin along the normal", 60,
            [](Collision& c, int k) {
              c = known_spheres();
              c.b.angular_velocity = std::ldexp(1.0, k) * c.normal;
            }),
      sweep("rest after the impulse", 60,
            [](Collision& c, int k) {
              c.restitution = 0;
              c.b.immovable = true;
              c.b.angular_velocity.setZero();
              c.b.velocity.setZero();
              c.a.position = c.point + 0.5 * c.normal;
              c.a.angular_velocity.setZero();
              c.a.velocity = -c.normal + std::ldexp(1.0, -k) * Vector3<double>(2, -0.25, 0);
            }),
      sweep("divisor of the cone", 54,
            [=](Collision& c, int k) {
              c = zero_divisor;
              c.friction *= 1 + std::ldexp(1.0, -k);
            }),
      sweep("tangential velocity", 60, [](Collision& c, int k) {
        c.a.angular_velocity.setZero();
        c.b.angular_velocity.setZero();
        c.b.velocity.setZero();
        c.a.velocity = -c.normal + std::ldexp(1.0, -k) * Vector3<double>(2, -0.25, 0);
      })};
  for (const double sign : {1.0, -1.0}) {
    const std::string from = sign > 0 ? ", above" : ", below";
    all.push_back({"normal velocity" + from, 120, [sign](int k) {
                     Collision c = grazing_collision(0);
                     c.a.velocity[2] = sign * std::ldexp(1.0, -k);
                     return c;
                   }});
    all.push_back(sweep("friction" + from, 54,
                        [=](Collision& c, int k) { c.friction = surface * (1 + sign * std::ldexp(0.5, -k)); }));
  }
  return all;
}

}  // namespace carom::unit
