// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/oracles/exact/radical.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/judge/exact_case.hpp>

/// Fixed collisions, which do not depend on the families.
namespace carom::unit {

struct KnownCollision {
  std::string name;
  Collision collision;
};

/// Two rotated bodies that spin and collide, with some friction, and no special feature.
[[nodiscard]] inline Collision plain_collision() {
  Collision c;
  c.a = {false, 2, {0.5, 0.75, 1}, {1, 0.5, -0.25, 0.125}, {0.25, 1.5, -0.5}, {1.5, -3, 0.75}, {0.5, -1.25, 2}};
  c.b = {false, 5, {1.5, 2, 2.75}, {0.75, -0.5, 1, 0.25}, {-0.5, -1.25, 0.375}, {-0.5, 1, 0.25}, {1, 0.75, -0.5}};
  c.point = {0.125, 0.25, -0.0625};
  c.normal = {0.25, 2, -0.5};
  c.restitution = 0.5;
  c.friction = 0.25;
  c.tangential_restitution = 0.375;
  return c;
}

/// Both lever arms are along the normal. The moments of each body are equal.
[[nodiscard]] inline Collision known_spheres() {
  Collision c = plain_collision();
  c.a.principal_inertia.setConstant(0.75);
  c.b.principal_inertia.setConstant(2);
  c.a.position = c.point + 0.5 * c.normal;
  c.b.position = c.point - 0.25 * c.normal;
  return c;
}

/// N·V⁻ is `sign` · 2⁻⁵¹, and the velocities are of order 1.
[[nodiscard]] inline Collision grazing_collision(double sign) {
  Collision c = plain_collision();
  c.a.velocity = {2, -0.25 + sign * 0x1p-52, 0};
  c.b.velocity.setZero();
  c.a.angular_velocity.setZero();
  c.b.angular_velocity.setZero();
  return c;
}

[[nodiscard]] inline std::vector<KnownCollision> known_collisions() {
  std::vector<KnownCollision> all{
      {"plain", plain_collision()},           {"much_friction", plain_collision()}, {"no_friction", plain_collision()},
      {"b_immovable", plain_collision()},     {"a_immovable", plain_collision()},   {"far", plain_collision()},
      {"farther", plain_collision()},         {"separating", plain_collision()},    {"needles", plain_collision()},
      {"spheres", known_spheres()},           {"head_on", known_spheres()},         {"grazing", grazing_collision(-1)},
      {"just_apart", grazing_collision(1)},   {"huge", plain_collision()},          {"unlike", plain_collision()},
      {"spins_about_normal", known_spheres()}};
  const auto named = [&](const char* name) -> Collision& {
    for (KnownCollision& one : all) {
      if (one.name == name) {
        return one.collision;
      }
    }
    throw std::logic_error(name);
  };
  named("much_friction").friction = 4;
  named("no_friction").friction = 0;
  named("b_immovable").b.immovable = true;
  named("a_immovable").a.immovable = true;
  for (const auto& [name, distance] : {std::pair("far", 0x1p+16), std::pair("farther", 0x1p+40)}) {
    Collision& c = named(name);
    for (Vector3<double>* place : {&c.a.position, &c.b.position, &c.point}) {
      *place += Vector3<double>(distance, -distance / 4, 0);
    }
  }
  named("separating").normal *= -1;
  named("needles").a.principal_inertia[0] = 0x1p-20;
  named("needles").b.principal_inertia[2] = 0x1p-18;
  named("head_on").a.velocity = -2 * named("head_on").normal;
  named("head_on").b.velocity = named("head_on").normal;
  named("head_on").a.angular_velocity.setZero();
  named("head_on").b.angular_velocity.setZero();
  for (Body* body : {&named("huge").a, &named("huge").b}) {
    body->mass *= 0x1p+600;
    body->principal_inertia *= 0x1p+600;
    body->velocity *= 0x1p+300;
    body->angular_velocity *= 0x1p+300;
  }
  named("unlike").b.mass *= 0x1p+30;
  named("unlike").b.principal_inertia *= 0x1p+36;
  named("unlike").b.position *= 8;
  named("spins_about_normal").a.angular_velocity = 512 * named("spins_about_normal").normal;
  return all;
}

[[nodiscard]] inline const oracles::Rational& nearly(const oracles::Rational& x) { return x; }
[[nodiscard]] inline oracles::Rational nearly(const oracles::Radical& x) { return oracles::approximately(x); }

/// The exact outcome of the law; for `coulomb`, the first of its answers. Irrational square roots are rounded, to far
/// more digits than the judge compares.
[[nodiscard]] inline Outcome<oracles::Rational> outcome_of_law(const oracles::ExactCase& exact_case, Law law) {
  const auto rational = []<class T>(const oracles::Truth<T>& truth) {
    return map_outcome<oracles::Rational>(truth.outcome, [](const T& x) { return nearly(x); });
  };
  return law == Law::coulomb ? rational(oracles::coulomb_answers(exact_case).front().truth)
                             : exact_case.with_truth(law, exact_case.state(), rational);
}

[[nodiscard]] inline long double rounded_to_binary64(const oracles::Rational& number) {
  return static_cast<long double>(oracles::nearest_double(number));
}

/// The number in extended precision, within one ulp.
[[nodiscard]] inline long double to_extended(const oracles::Rational& number) {
  const double high = oracles::to_double(number);
  if (!std::isfinite(high)) {
    return static_cast<long double>(high);
  }
  return static_cast<long double>(high) +
         static_cast<long double>(oracles::to_double(number - oracles::Rational(high)));
}

/// The outcome_of_law, rounded to binary64, as a subject reports it.
[[nodiscard]] inline ReportedOutcome reported_outcome(const oracles::ExactCase& exact_case, Law law) {
  return map_outcome<long double>(outcome_of_law(exact_case, law), rounded_to_binary64);
}

/// Like reported_outcome, but also with the collision matrix, rounded to binary64.
[[nodiscard]] inline ReportedOutcome reported_outcome_with_matrix(const oracles::ExactCase& exact_case, Law law) {
  ReportedOutcome reported = reported_outcome(exact_case, law);
  reported.collision_matrix = exact_case.collision_matrix().unaryExpr(&rounded_to_binary64);
  return reported;
}

}  // namespace carom::unit
