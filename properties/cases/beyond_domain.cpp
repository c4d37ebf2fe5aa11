// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/friction.hpp>
#include <carom/properties/draws/general_collision.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>

namespace carom::properties {
namespace {

/// tr([r]ᵀ J⁻¹ [r]) = Σ ‖e × r‖² / I over the body axes e, with the moment I about e.
double response_to_torque(const Collision& collision, const Body& body) {
  if (body.immovable) {
    return 0;
  }
  const Vector3<double> lever_arm = collision.point - body.position;
  const Vector3<double> r = turned(conjugate(body.orientation), lever_arm);
  double trace = 0;
  for (int i = 0; i < 3; ++i) {
    const double y = r[(i + 1) % 3];
    const double z = r[(i + 2) % 3];
    trace += (y * y + z * z) / body.principal_inertia[i];
  }
  return trace;
}

double inverse_mass(const Body& body) { return body.immovable ? 0 : 1 / body.mass; }

double excess_of(const Body& body) {
  if (body.immovable) {
    return 0;
  }
  Vector3<double> others = body.principal_inertia;
  const int largest = place_of_least(negated(others));
  others[largest] = 0;
  return body.principal_inertia[largest] / sum(others);
}

/// At times, A becomes immovable and only B is chosen.
std::vector<Body*> chosen_bodies(Stream& stream, Collision& c) {
  switch (stream.integer(0, 3)) {
    case 0:
      return {&c.a, &c.b};
    case 1:
      return {&c.a};
    case 2:
      return {&c.b};
    default:
      make_immovable(c.a);
      return {&c.b};
  }
}

}  // namespace

double condition_number_at_most(const Collision& c) {
  const double lambda = inverse_mass(c.a) + inverse_mass(c.b);
  return lambda == 0 ? 1 : 1 + (response_to_torque(c, c.a) + response_to_torque(c, c.b)) / lambda;
}

double greatest_moment_ratio(const Collision& c) { return std::max(moment_ratio(c.a), moment_ratio(c.b)); }

double moment_excess(const Collision& c) { return std::max(excess_of(c.a), excess_of(c.b)); }

bool is_no_further_beyond_domain(const Collision& collision, const Collision& other) {
  const auto is_no_further_in_moments = [](const Body& body, const Body& of_other) {
    constexpr double free_ratio = 8;
    return excess_of(body) <= std::max(1.0, excess_of(of_other)) &&
           moment_ratio(body) <= std::max(free_ratio, moment_ratio(of_other));
  };
  // If both bodies are uniform and convex, then K ⪯ 16 λI, so tr(K − λI) / λ is at most 3 · 15.
  constexpr double free_condition = 1 + 3 * 15;
  return is_no_further_in_moments(collision.a, other.a) && is_no_further_in_moments(collision.b, other.b) &&
         condition_number_at_most(collision) <= std::max(free_condition, condition_number_at_most(other));
}

void set_moment_excess(Stream& stream, Body& body, double excess) {
  const int largest = stream.integer(0, 2);
  const double part = stream.between(0.0625, 0.9375);
  const double share = stream.chance(2) ? part : part * 0x1p-20;
  const double others = body.principal_inertia[largest] / excess;
  body.principal_inertia[(largest + 1) % 3] = others * share;
  body.principal_inertia[(largest + 2) % 3] = others * (1 - share);
}

void strike_close(Stream& stream, const Collision& collision, Body& body) {
  const Vector3<double> lever_arm = collision.point - body.position;
  const double reach = std::sqrt(least(body.principal_inertia) / body.mass) * stream.unit();
  if (length(lever_arm) > 0) {
    body.position = plus(collision.point, lever_arm, -reach / length(lever_arm));
  }
}

Case far_contacts(Stream& stream) {
  Case result = general_bodies(stream);
  Collision& c = result.collision;
  set_friction(stream, c);
  for (Body* body : chosen_bodies(stream, c)) {
    const double times = stream.power_of_two(0, 26);  // κ(K) grows by the square of this factor
    if (stream.chance(2)) {
      const Vector3<double> lever_arm = c.point - body->position;
      body->position = plus(c.point, lever_arm, -times);
      // Without this, w × r would always dominate the approach velocity.
      body->angular_velocity /= stream.chance(2) ? times : 1;
    } else {
      body->principal_inertia /= times * times;
    }
  }
  make_approaching(c);
  return result;
}

Case impossible_moments(Stream& stream) {
  Case result = general_bodies(stream);
  Collision& c = result.collision;
  set_friction(stream, c);
  for (Body* body : chosen_bodies(stream, c)) {
    const double decade = stream.power_of_ten(0, 16);
    set_moment_excess(stream, *body, decade * (1 + stream.unit()));
    if (stream.chance(2)) {
      strike_close(stream, c, *body);
    }
  }
  make_approaching(c);
  return result;
}

namespace {

struct Needle {
  Body body;
  Vector3<double> axis;  // of about unit length, from the centre of mass to the tip
};

/// Zero, or 10^-k with k = 1 to 18.
double small_or_zero(Stream& stream) { return stream.chance(4) ? 0 : stream.power_of_ten(-18, -1); }

/// The needle has its tip, or a place near the tip, at `point`.
Needle needle(Stream& stream, const Vector3<double>& point) {
  // a² / S: a is the distance from the centre of mass to the tip, and S the mean of the squared coordinates along the
  // axis. The shapes are a prism struck on its end face, an ellipsoid, a double pyramid, and a pyramid with its apex.
  constexpr std::array squared_reaches{3.0, 5.0, 10.0, 15.0};
  const double squared_reach = squared_reaches[static_cast<std::size_t>(stream.integer(0, 3))];
  const int along = stream.integer(0, 2);
  const double length = stream.power_of_two(-3, 3);
  const double width = length * stream.power_of_ten(-6, -1);
  // At the share t of a below its tip, each shape contains the points within t/4 of its semi-widths.
  const double depth = small_or_zero(stream);
  Vector3<double> second_moments;
  Vector3<double> tip;
  for (int i = 0; i < 3; ++i) {
    const double semi_width = width * stream.between(0.5, 1.5);
    const double beside = semi_width * (depth / 4 * stream.signed_unit());
    second_moments[i] = i == along ? length * length / squared_reach : semi_width * semi_width / 5;
    tip[i] = i == along ? length * (1 - depth) : beside;
  }
  Vector3<double> axis{0, 0, 0};
  axis[along] = stream.chance(2) ? 1 : -1;
  tip[along] *= axis[along];
  Needle result;
  result.body.mass = drawn_mass(stream);
  result.body.principal_inertia = principal_moments(result.body.mass, second_moments);
  result.body.orientation = stream.quaternion();
  result.body.position = point - turned(result.body.orientation, tip);
  result.axis = turned(result.body.orientation, axis);
  set_velocities(stream, result.body, length);
  return result;
}

/// The body that the needle strikes.
Body struck_body(Stream& stream, const Vector3<double>& point) {
  switch (stream.integer(0, 2)) {
    case 0: {
      Body wall = convex_body(stream, point);
      make_immovable(wall);
      return wall;
    }
    case 1:
      return needle(stream, point).body;
    default:
      return convex_body(stream, point);
  }
}

}  // namespace

Case needle_tip(Stream& stream) {
  Case result;
  result.convex_uniform = true;
  Collision& c = result.collision;
  // From the origin, the rounded lever arms are −X, exactly.
  const double distance = stream.chance(2) ? 0 : stream.power_of_two(-2, 2);
  c.point = stream.vector() * distance;
  const bool a_is_needle = stream.chance(2);
  const Needle struck_on_tip = needle(stream, c.point);
  const Body other = struck_body(stream, c.point);
  c.a = a_is_needle ? struck_on_tip.body : other;
  c.b = a_is_needle ? other : struck_on_tip.body;
  const Vector3<double>& axis = struck_on_tip.axis;
  // N points from B to A: from the tip of A to its centre, or from the centre of B to its tip.
  c.normal = plus(axis * (a_is_needle ? -1.0 : 1.0), orthogonal(axis), small_or_zero(stream));
  const double speed = stream.power_of_two(-3, 3);
  set_relative_velocity(c, plus(c.normal * -speed, orthogonal(c.normal), speed * small_or_zero(stream)));
  c.restitution = drawn_restitution(stream);
  set_friction(stream, c);
  return result;
}

}  // namespace carom::properties
