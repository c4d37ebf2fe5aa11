// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <limits>

#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/friction.hpp>
#include <carom/properties/cases/published.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/features/compose.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties {
namespace {

/// ‖V‖, or 1 if V = 0.
double speed_of(const Collision& c) {
  const double speed = length(relative_velocity(c));
  return speed > 0 ? speed : 1;
}

Case generic(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  if (stream.chance(8)) {
    result.collision.normal = negated(result.collision.normal);
  }
  return result;
}

/// V is −N times a power of two: exactly if the bodies do not spin, otherwise up to rounding.
Case head_on(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  Collision& c = result.collision;
  if (stream.chance(2)) {
    c.a.angular_velocity.setZero();
    c.b.angular_velocity.setZero();
    c.b.velocity.setZero();
    c.a.velocity = c.normal * -stream.power_of_two(-3, 3);
  } else {
    set_relative_velocity(c, c.normal * -stream.power_of_two(-3, 3));
  }
  return result;
}

Case near_head_on(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  Collision& c = result.collision;
  const double speed = stream.power_of_two(-3, 3);
  const double ratio = stream.power_of_ten(-18, -1);
  if (stream.chance(2)) {
    c.a.angular_velocity.setZero();
    c.b.angular_velocity.setZero();
    c.b.velocity.setZero();
  }
  set_relative_velocity(c, plus(c.normal * -speed, orthogonal(c.normal), speed * ratio));
  return result;
}

/// At times, one sphere is a wall, or the spheres meet head-on without spin. If both happen and ε = 0, the outcome is
/// zero.
Case collinear_spheres(Stream& stream) {
  Case result = touching_spheres(stream);
  Collision& c = result.collision;
  if (stream.chance(4)) {
    make_immovable(stream.chance(2) ? c.a : c.b);
  }
  if (stream.chance(4)) {
    for (Body* body : {&c.a, &c.b}) {
      body->velocity.setZero();
      body->angular_velocity.setZero();
    }
    const Vector3<double> approach = c.normal * stream.between(0.125, 8);
    if (c.a.immovable) {
      c.b.velocity = approach;
    } else {
      c.a.velocity = negated(approach);
    }
  } else if (dot(c.normal, relative_velocity(c)) > 0) {
    c.a.velocity = negated(c.a.velocity);
    c.b.velocity = negated(c.b.velocity);
  }
  return result;
}

Case near_collinear(Stream& stream) {
  Case result = touching_spheres(stream);
  Collision& c = result.collision;
  const double radius = length(c.point - c.a.position);
  c.point = plus(c.point, orthogonal(c.normal), radius * stream.power_of_ten(-16, -1));
  make_approaching(c);
  result.convex_uniform = false;
  return result;
}

Case grazing(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  Collision& c = result.collision;
  const double magnitude = stream.power_of_ten(-18, -1);
  const double ratio = stream.chance(4) ? magnitude : -magnitude;
  set_relative_velocity(c, plus(orthogonal(c.normal), c.normal, ratio) * speed_of(c));
  return result;
}

Case resting(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  Collision& c = result.collision;
  c.a.angular_velocity.setZero();
  c.b.angular_velocity.setZero();
  c.b.velocity.setZero();
  c.a.velocity = stream.chance(3) ? Vector3<double>(Vector3<double>::Zero())
                                  : Vector3<double>(orthogonal(c.normal) * stream.power_of_two(-3, 3));
  return result;
}

Case separating(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  result.collision.normal = negated(result.collision.normal);
  return result;
}

Case with_restitution(Stream& stream, double restitution) {
  Case result = sprinkled_bodies(stream);
  result.collision.restitution = restitution;
  return result;
}

Case inelastic(Stream& stream) { return with_restitution(stream, 0); }

Case elastic(Stream& stream) { return with_restitution(stream, 1); }

Case mass_ratio(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  Collision& c = result.collision;
  const double ratio = stream.power_of_ten(1, 9);
  Body& heavy = stream.chance(2) ? c.a : c.b;
  features::scale_mass(heavy, ratio);
  return result;
}

Case mass_scale(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  const double scale = stream.power_of_ten(-12, 12);
  for (Body* body : {&result.collision.a, &result.collision.b}) {
    features::scale_mass(*body, scale);
  }
  return result;
}

Case with_immovable(Stream& stream, bool a, bool b) {
  Case result = sprinkled_bodies(stream);
  Collision& c = result.collision;
  if (a) {
    make_immovable(c.a);
  }
  if (b) {
    make_immovable(c.b);
  }
  make_approaching(c);
  return result;
}

Case immovable_a(Stream& stream) { return with_immovable(stream, true, false); }

Case immovable_b(Stream& stream) { return with_immovable(stream, false, true); }

void drive(Stream& stream, Body& wall) {
  const double speed = stream.power_of_two(-3, 3);
  wall.velocity = stream.vector() * speed;
  const double angular_speed = stream.power_of_two(-3, 3);
  wall.angular_velocity = stream.vector() * angular_speed;
}

Case driven_wall(Stream& stream) {
  const bool a_is_wall = stream.chance(2);
  Case result = with_immovable(stream, a_is_wall, !a_is_wall);
  drive(stream, a_is_wall ? result.collision.a : result.collision.b);
  make_approaching(result.collision);
  return result;
}

Case both_immovable(Stream& stream) {
  Case result = with_immovable(stream, true, true);
  drive(stream, result.collision.a);
  drive(stream, result.collision.b);
  make_approaching(result.collision);
  return result;
}

Case zero_lever(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  Collision& c = result.collision;
  const int which = stream.integer(0, 2);
  if (which != 1) {
    c.a.position = c.point;
  }
  if (which != 0) {
    c.b.position = c.point;
  }
  make_approaching(c);
  return result;
}

Case far_from_origin(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  Collision& c = result.collision;
  const double distance = stream.power_of_ten(1, 12);
  const Vector3<double> offset = stream.vector() * distance;
  c.point += offset;
  c.a.position += offset;
  c.b.position += offset;
  make_approaching(c);
  return result;
}

Case common_velocity(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  Collision& c = result.collision;
  const double speed = stream.power_of_ten(1, 12);
  const Vector3<double> common = stream.vector() * speed;
  c.a.velocity += common;
  c.b.velocity += common;
  make_approaching(c);
  return result;
}

Case fast_spin(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  Collision& c = result.collision;
  const double scale = stream.power_of_ten(1, 6);
  c.a.angular_velocity *= scale;
  c.b.angular_velocity *= scale;
  make_approaching(c);
  return result;
}

Case slow(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  const double scale = stream.power_of_ten(-12, -1);
  for (Body* body : {&result.collision.a, &result.collision.b}) {
    body->velocity *= scale;
    body->angular_velocity *= scale;
  }
  return result;
}

Case long_normal(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  result.collision.normal *= stream.power_of_ten(-30, 30);
  return result;
}

Case long_quaternion(Stream& stream) {
  Case result = sprinkled_bodies(stream);
  result.collision.a.orientation *= stream.power_of_ten(-30, 30);
  result.collision.b.orientation *= stream.power_of_ten(-30, 30);
  return result;
}

Case structured(Stream& stream) { return {structured_collision(stream), false}; }

/// One case in two gets a μ at which the contact mostly sticks, because e_t acts on no other contact.
Case near_special(Stream& stream) {
  Case result = stream.chance(4) ? structured(stream) : sprinkled_bodies(stream);
  if (stream.chance(2)) {
    result.collision.friction = critical_friction(result.collision) * (1 + stream.power_of_ten(0, 2));
  }
  make_several_near(stream, result.collision);
  return result;
}

void make_not_finite(Stream& stream, Collision& collision) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::array not_finite{std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};
  const double value = not_finite.at(static_cast<std::size_t>(stream.integer(0, 2)));
  int count = 0;
  for_each_number([&](const FieldPath&, double&) { ++count; }, collision);
  int chosen = stream.integer(0, count - 1);
  for_each_number(
      [&](const FieldPath&, double& number) {
        if (chosen-- == 0) {
          number = value;
        }
      },
      collision);
}

void put_out_of_range(Stream& stream, Collision& c) {
  Body& body = stream.chance(2) ? c.a : c.b;
  const double zero_or_less = stream.chance(2) ? 0 : -stream.between(0.125, 8);
  switch (stream.integer(0, 7)) {
    case 0:
      body.mass = zero_or_less;
      break;
    case 1:
      body.principal_inertia[stream.integer(0, 2)] = zero_or_less;
      break;
    case 2:
      body.orientation.setZero();
      break;
    case 3:
      c.normal.setZero();
      break;
    case 4:
      c.restitution = -stream.between(0.125, 8);
      break;
    case 5:
      c.restitution = 1 + stream.between(0.125, 8);
      break;
    case 6:
      c.friction = -stream.between(0.125, 8);
      break;
    default:
      c.tangential_restitution = 1 + stream.between(0.125, 8);
      if (!stream.chance(2)) {
        c.tangential_restitution = -c.tangential_restitution;
      }
  }
}

/// `general_bodies` with one invalid field: a random number is not finite, or a random field is out of range.
Case invalid(Stream& stream) {
  Case result = general_bodies(stream);
  if (stream.chance(2)) {
    make_not_finite(stream, result.collision);
  } else {
    put_out_of_range(stream, result.collision);
  }
  return result;
}

bool is_of_immovable_a(const Collision& c) { return c.a.immovable && !c.b.immovable; }

bool is_of_immovable_b(const Collision& c) { return !c.a.immovable && c.b.immovable; }

bool is_of_driven_wall(const Collision& c) {
  return c.a.immovable != c.b.immovable && !features::is_at_rest(c.a.immovable ? c.a : c.b);
}

bool is_of_both_immovable(const Collision& c) {
  return c.a.immovable && c.b.immovable && !(features::is_at_rest(c.a) && features::is_at_rest(c.b));
}

bool is_of_zero_lever(const Collision& c) { return c.a.position == c.point || c.b.position == c.point; }

bool is_beside_centres(const Collision& c) {
  const auto is_beside = [&](const Body& body) {
    return !body.immovable && !features::are_parallel(features::lever_arm(c, body), c.normal);
  };
  return is_beside(c.a) || is_beside(c.b);
}

constexpr std::array families{
    Family{"structured", "combinations of special values, relations and magnitudes, as in scenes", structured, 1, 20},
    Family{"generic", "two general bodies, of which seven in eight pairs approach", generic, 22},
    Family{"physical",
           "convex bodies of uniform density, including plates and rods with moments up to 1 : 10⁸; the contact is in "
           "or on both",
           convex_bodies, 23},
    Family{"near_special", "values and relations that are special but for a relative distance of 10^-k, k = 1 to 15",
           near_special, 36, 2},
    Family{"head_on", "V⁻ along the normal, exactly or up to rounding", head_on, 5},
    Family{"near_head_on", "v_t/v_n = 10^-k, k = 1 to 18", near_head_on, 10},
    Family{"collinear_spheres",
           "two touching spheres, or a sphere and a wall; centres and contact lie exactly on one line along N",
           collinear_spheres, 31},
    Family{"near_collinear",
           "touching spheres; the contact is 10^-k radii away from the line of centres, k = 1 to 16",
           near_collinear,
           28,
           1,
           true,
           {},
           {},
           is_beside_centres},
    Family{"grazing", "|N·V⁻| = 10^-k ‖V⁻‖, k = 1 to 18, approaching or separating", grazing, 7},
    Family{"resting", "N·V⁻ = 0 exactly", resting, 33},
    Family{"separating", "N·V⁻ > 0: no impulse", separating, 32},
    Family{"inelastic", "restitution 0", inelastic, 27, 1, true, {}, LimitedQuantity::restitution},
    Family{"elastic", "restitution 1", elastic, 24, 1, true, {}, LimitedQuantity::restitution},
    Family{"mass_ratio", "one body is 10^k times as heavy as the other, k = 1 to 9", mass_ratio, 9},
    Family{"mass_scale", "the masses of both bodies are multiplied by 10^k, k = -12 to 12", mass_scale, 15},
    Family{"immovable_a", "A has infinite mass", immovable_a, 14, 1, true, {}, {}, is_of_immovable_a},
    Family{"immovable_b", "B has infinite mass", immovable_b, 18, 1, true, {}, {}, is_of_immovable_b},
    Family{"driven_wall", "one body has infinite mass and moves", driven_wall, 4, 1, true, {}, {}, is_of_driven_wall},
    Family{"both_immovable",
           "both bodies have infinite mass and move: no impulse",
           both_immovable,
           3,
           1,
           true,
           {},
           {},
           is_of_both_immovable},
    Family{"zero_lever",
           "the contact is at the centre of mass of one body or of both",
           zero_lever,
           12,
           1,
           true,
           {},
           {},
           is_of_zero_lever},
    Family{"far_from_origin", "bodies 10^k m from the origin, k = 1 to 12", far_from_origin, 21},
    Family{"common_velocity", "both bodies have an additional common velocity of 10^k m/s, k = 1 to 12",
           common_velocity, 25},
    Family{"fast_spin", "angular velocities are multiplied by 10^k, k = 1 to 6", fast_spin, 19},
    Family{"long_normal", "a normal of length 10^k, k = -30 to 30", long_normal, 26},
    Family{"long_quaternion", "orientations of length 10^k, k = -30 to 30", long_quaternion, 13},
    Family{"slow", "velocities are multiplied by 10^-k, k = 1 to 12", slow, 8},
    Family{"sticking",
           "μ is larger than the least μ that allows the full tangential impulse, by a fraction of 10^-3 to 10^2",
           sticking, 17},
    Family{"sliding", "μ is smaller than the least μ that allows the full tangential impulse", sliding, 11},
    Family{"on_the_cone",
           "μ differs by a fraction of 10^-k from the least μ that allows the full tangential impulse, k = 1 to 18",
           on_the_cone,
           2,
           1,
           true,
           {},
           LimitedQuantity::friction},
    Family{"stick_or_slip",
           "μ differs by a fraction of 10^-k from the least μ at which the law coulomb sticks, k = 1 to 18",
           stick_or_slip,
           34,
           1,
           true,
           {},
           LimitedQuantity::friction},
    Family{"no_friction", "μ = 0, any e_t", no_friction, 29, 1, true, {}, LimitedQuantity::friction},
    Family{"great_friction", "μ = 10^k, k = 0 to 9", great_friction, 20, 1, true, {}, LimitedQuantity::friction},
    Family{"spin_alone", "touching spheres that slip only because of their spins", spin_alone, 30},
    Family{"special_tangential_restitution",
           "e_t = −1, 0 or 1",
           special_tangential_restitution,
           16,
           1,
           true,
           {},
           LimitedQuantity::tangential_restitution},
    Family{"chung_ooi", "the eight benchmark impacts of spheres by Y. Chung and J. Ooi, with published answers",
           chung_ooi, 35},
    Family{"invalid", "one field is not finite, negative, zero or out of range; a subject must refuse the collision",
           invalid, 6, 1, false},
};

constexpr std::array beyond_domain{
    Family{
        "far_contacts",
        "the contact is far outside of a body: its lever arm is multiplied by 2^k, or its moments by 4^-k, k = 0 to 26",
        far_contacts,
        last_turn,
        1,
        true,
        {"upper bound of κ(K)", condition_number_at_most}},
    Family{"impossible_moments",
           "one moment is 10^k times the sum of the other two, k = 0 to 16",
           impossible_moments,
           last_turn,
           1,
           true,
           {"a moment over the sum of the other two", moment_excess}},
    Family{"needle_tip",
           "needles with moments up to 1 : 10¹² that are struck on the tip; N and V⁻ lie along the long axis, or "
           "deviate from it by 10^-k, k = 1 to 18",
           needle_tip,
           last_turn,
           1,
           true,
           {"the greatest moment over the least", greatest_moment_ratio}},
};

}  // namespace

std::span<const Family> all_families() { return families; }

std::span<const Family> families_beyond_domain() { return beyond_domain; }

}  // namespace carom::properties
