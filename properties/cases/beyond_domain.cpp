// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/friction.hpp>
#include <carom/properties/draws/moment_ratio.hpp>
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

}  // namespace carom::properties
