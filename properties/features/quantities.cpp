// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/draws/general_collision.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/features/geometry.hpp>
#include <carom/properties/features/quantities.hpp>

namespace carom::properties {
namespace {

using V = Vector3<double>;

double arm(const Collision& c, const Body& b) { return length(features::lever_arm(c, b)); }

double approach_speed(const Collision& c) { return std::abs(dot(c.normal, relative_velocity(c))) / length(c.normal); }
double slip_speed(const Collision& c) { return length(cross(c.normal, relative_velocity(c))) / length(c.normal); }

/// The lesser positive value of the two bodies; infinite if there is none.
template <class OfBody>
double lesser(const Collision& c, const OfBody& of) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Body* body : {&c.a, &c.b}) {
    const double x = of(*body);
    smallest = x > 0 ? std::min(smallest, x) : smallest;
  }
  return smallest;
}
template <class OfBody>
double greater(const Collision& c, const OfBody& of) {
  return std::max(of(c.a), of(c.b));
}

double mass(const Body& b) { return b.immovable ? 0 : b.mass; }
double least_moment(const Body& b) { return b.immovable ? 0 : least(b.principal_inertia); }
double greatest_moment(const Body& b) { return b.immovable ? 0 : greatest(b.principal_inertia); }
double product_of_moments(const Body& b) {
  const V& moments = b.principal_inertia;
  return b.immovable ? 0 : moments[0] * moments[1] * moments[2];
}
double speed(const Body& b) { return length(b.velocity); }
double spin(const Body& b) { return length(b.angular_velocity); }
double quaternion_length(const Body& b) { return b.immovable ? 0 : std::sqrt(squared_length(b.orientation)); }
/// From 0 to π [rad].
double angle(const Body& b) {
  return b.immovable ? 0 : 2 * std::atan2(length(b.orientation.tail<3>()), std::abs(b.orientation[0]));
}

const std::vector<ComparedQuantity> quantities{
    {"the smaller mass [kg]", [](const Collision& c) { return lesser(c, mass); }},
    {"the larger mass [kg]", [](const Collision& c) { return greater(c, mass); }},
    {"the larger mass over the smaller",
     [](const Collision& c) { return c.a.immovable || c.b.immovable ? 0 : greater(c, mass) / lesser(c, mass); }},
    {"the least moment of inertia [kg m²]", [](const Collision& c) { return lesser(c, least_moment); }},
    {"the greatest moment of inertia [kg m²]", [](const Collision& c) { return greater(c, greatest_moment); }},
    {"the smaller product of a body's three moments [kg³ m⁶]",
     [](const Collision& c) { return lesser(c, product_of_moments); }},
    {ratio_of_moments, [](const Collision& c) { return greater(c, moment_ratio); }},
    {"the shorter lever arm [m]",
     [](const Collision& c) { return lesser(c, [&](const Body& b) { return arm(c, b); }); }},
    {"the longer lever arm [m]",
     [](const Collision& c) { return greater(c, [&](const Body& b) { return arm(c, b); }); }},
    {"the smallest nonzero speed [m/s]", [](const Collision& c) { return lesser(c, speed); }},
    {"the larger speed [m/s]", [](const Collision& c) { return greater(c, speed); }},
    {"the smallest nonzero spin [rad/s]", [](const Collision& c) { return lesser(c, spin); }},
    {"the larger spin [rad/s]", [](const Collision& c) { return greater(c, spin); }},
    {"the speed of approach [m/s]", approach_speed},
    {"the slip [m/s]", slip_speed},
    {"the slip over the speed of approach", [](const Collision& c) { return slip_speed(c) / approach_speed(c); }},
    {"the length of the normal", [](const Collision& c) { return length(c.normal); }},
    {"the angle between the normal and the nearest axis [rad]",
     [](const Collision& c) {
       V rest = c.normal;
       const int largest = place_of_least(negated(V(c.normal.cwiseAbs())));
       rest[largest] = 0;
       return std::atan2(length(rest), std::abs(c.normal[largest]));
     }},
    {"the length of the shorter quaternion", [](const Collision& c) { return lesser(c, quaternion_length); }},
    {"the length of the longer quaternion", [](const Collision& c) { return greater(c, quaternion_length); }},
    {"the smallest nonzero angle of rotation [rad]", [](const Collision& c) { return lesser(c, angle); }},
    {"the distance of the contact from the origin [m]", [](const Collision& c) { return length(c.point); }},
    {"the restitution", [](const Collision& c) { return c.restitution; }},
    {"the friction", [](const Collision& c) { return c.friction; }},
    {"the lighter body's mass times the speed of approach [N s]",
     [](const Collision& c) { return lesser(c, mass) * approach_speed(c); }},
};

}  // namespace

std::span<const ComparedQuantity> all_compared_quantities() { return quantities; }

std::vector<float> quantities_of(const Collision& collision) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  std::vector<float> logarithms;
  logarithms.reserve(quantities.size());
  for (const ComparedQuantity& quantity : quantities) {
    const double x = quantity.of(collision);
    logarithms.push_back(x > 0 && std::isfinite(x) ? static_cast<float>(std::log10(x))
                                                   : std::numeric_limits<float>::quiet_NaN());
  }
  return logarithms;
}

}  // namespace carom::properties
