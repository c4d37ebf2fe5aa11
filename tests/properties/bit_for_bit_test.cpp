// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "examination.hpp"

namespace carom::properties {
namespace {

using oracles::Rational;

struct Relation {
  Collision (*map)(Collision);
  Outcome<Rational> (*map_outcome)(Outcome<Rational>);
};

Collision swapped(Collision c) {
  std::swap(c.a, c.b);
  c.normal = -c.normal;
  return c;
}
Outcome<Rational> swapped_outcome(Outcome<Rational> y) {
  std::swap(y.a, y.b);
  return y;
}

template <int Axis, class Vector>
void mirror_polar(Vector& v) { v[Axis] = -v[Axis]; }
template <int Axis, class Vector>
void mirror_axial(Vector& v) { v = -v; v[Axis] = -v[Axis]; }

template <int Axis>
Collision mirrored(Collision c) {
  for (Body* body : {&c.a, &c.b}) {
    mirror_polar<Axis>(body->position);
    mirror_polar<Axis>(body->velocity);
    mirror_axial<Axis>(body->angular_velocity);
    Vector3<double> imaginary = body->orientation.tail<3>();
    mirror_axial<Axis>(imaginary);
    body->orientation.tail<3>() = imaginary;
  }
  mirror_polar<Axis>(c.point);
  mirror_polar<Axis>(c.normal);
  return c;
}
template <int Axis>
Outcome<Rational> mirrored_outcome(Outcome<Rational> y) {
  for (auto* m : {&y.a, &y.b}) {
    mirror_polar<Axis>(m->velocity);
    mirror_axial<Axis>(m->angular_velocity);
  }
  return y;
}

template <int M, int L, int T>
Collision rescaled(Collision c) {
  for (Body* body : {&c.a, &c.b}) {
    body->mass *= std::ldexp(1.0, M);
    body->principal_inertia *= std::ldexp(1.0, M + 2 * L);
    body->position *= std::ldexp(1.0, L);
    body->velocity *= std::ldexp(1.0, L - T);
    body->angular_velocity *= std::ldexp(1.0, -T);
  }
  c.point *= std::ldexp(1.0, L);
  return c;
}
template <int M, int L, int T>
Outcome<Rational> rescaled_outcome(Outcome<Rational> y) {
  for (auto* m : {&y.a, &y.b}) {
    for (int i = 0; i < 3; ++i) {
      m->velocity[i] *= Rational(std::ldexp(1.0, L - T));
      m->angular_velocity[i] *= Rational(std::ldexp(1.0, -T));
    }
  }
  return y;
}

template <int From, int To, class Vector>
void turn(Vector& v) {
  auto was = v[To];
  v[To] = v[From];
  v[From] = -was;
}
template <int From, int To>
Collision turned(Collision c) {
  for (Body* body : {&c.a, &c.b}) {
    turn<From, To>(body->position);
    turn<From, To>(body->velocity);
    turn<From, To>(body->angular_velocity);
    Vector3<double> imaginary = body->orientation.tail<3>();
    turn<From, To>(imaginary);
    body->orientation.tail<3>() = imaginary;
    std::swap(body->principal_inertia[From], body->principal_inertia[To]);
  }
  turn<From, To>(c.point);
  turn<From, To>(c.normal);
  return c;
}
template <int From, int To>
Outcome<Rational> turned_outcome(Outcome<Rational> y) {
  for (auto* m : {&y.a, &y.b}) {
    turn<From, To>(m->velocity);
    turn<From, To>(m->angular_velocity);
  }
  return y;
}
template <int From, int To>
Collision upright_turned(Collision c) { return turned<From,To>(c); }

TEST(Explore, All) {
  const std::pair<const char*, Relation> relations[] = {
      {"swap", {swapped, swapped_outcome}},
      {"mirror x", {mirrored<0>, mirrored_outcome<0>}},
      {"mirror y", {mirrored<1>, mirrored_outcome<1>}},
      {"mirror z", {mirrored<2>, mirrored_outcome<2>}},
      {"scale 5 -3 2", {rescaled<5, -3, 2>, rescaled_outcome<5, -3, 2>}},
      {"scale 4 -3 2", {rescaled<4, -3, 2>, rescaled_outcome<4, -3, 2>}},
      {"scale 4 -3 1", {rescaled<4, -3, 1>, rescaled_outcome<4, -3, 1>}},
      {"about z", {turned<0, 1>, turned_outcome<0, 1>}},
      {"about x", {turned<1, 2>, turned_outcome<1, 2>}},
      {"about y", {turned<2, 0>, turned_outcome<2, 0>}},
  };
  for (int upright = 0; upright < 4; ++upright)
    for (const auto& [name, relation] : relations)
      for (const auto& e : built_in_examinees()) {
        int same = 0, differ = 0;
        std::string fams;
        for (const Family& f : all_families()) {
          if (f.name == "invalid") continue;
          bool d = false;
          for (int i = 0; i < 40; ++i) {
            Stream s = case_stream(5, f.name, i);
            Collision c = f.generate(s).collision;
            if (upright & 1)
              for (Body* b : {&c.a, &c.b}) b->orientation = {1, 0, 0, 0};
            if (upright & 2)
              for (Body* b : {&c.a, &c.b}) b->principal_inertia.setConstant(b->principal_inertia[0]);
            auto x = e.solve(c);
            auto y = e.solve(relation.map(c));
            auto px = std::get_if<oracles::LiftedOutcome>(&x);
            auto py = std::get_if<oracles::LiftedOutcome>(&y);
            if (!px || !py) { d = true; fams += "!"; continue; }
            auto m = relation.map_outcome(px->exact());
            bool eq = true;
            for (std::size_t k = 0; k < 4; ++k) eq = eq && *vectors(m)[k] == *vectors(py->exact())[k];
            (eq ? same : differ)++;
            d = d || !eq;
          }
          if (d) fams += std::string(f.name) + " ";
        }
        std::printf("%d %-14s %-32s same %d differ %d  %s\n", upright, name, e.name.c_str(), same, differ, differ < 200 ? fams.c_str() : "...");
      }
}

}  // namespace
}  // namespace carom::properties
