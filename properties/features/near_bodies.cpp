// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;
using Q = Quaternion<double>;

double length_of(const Q& q) { return std::sqrt(squared_length(q)); }

V axis_of(const Q& q) { return q.tail<3>(); }

/// The place in the quaternion of the greatest component of its axis.
int place_of_axis(const Q& q) { return 1 + place_of_least(negated(V(axis_of(q).cwiseAbs()))); }

/// q with its component `place` set to zero.
Q without(Q q, int place) {
  q[place] = 0;
  return q;
}

/// A random vector in four dimensions, about as long as 1.
Q some_quaternion(Stream& stream) {
  const Q q = stream.quaternion();
  return q / length_of(q);
}

/// `distance_of` gets the quaternion of a movable body, and `move` changes it.
Near of_quaternion(const char* of, double (*distance_of)(const Q&), void (*move)(Stream&, Q&, double)) {
  return {of, [=](const Collision&, const Body& b) { return b.immovable ? 0 : distance_of(b.orientation); },
          [=](Stream& stream, Collision&, Body& b, double distance) { move(stream, b.orientation, distance); }};
}

void turn_slightly(Stream& stream, Q& q, double distance) {
  const Q by = some_quaternion(stream);
  const double size = std::abs(q[0]) * distance;
  for (int i = 1; i < 4; ++i) {
    q[i] = size * by[i];
  }
}

void move_quaternion(Stream& stream, Q& q, double distance) {
  q += some_quaternion(stream) * (distance * length_of(q));
}

/// `distance_of` gets the moments of a movable body.
Near of_moments(const char* of, double (*distance_of)(const V&), void (*move)(Stream&, V&, double)) {
  return {of, [=](const Collision&, const Body& b) { return b.immovable ? 0 : distance_of(b.principal_inertia); },
          [=](Stream& stream, Collision&, Body& b, double distance) { move(stream, b.principal_inertia, distance); }};
}

/// The least relative difference of two moments.
double distance_from_equal_pair(const V& moments) {
  double nearest = 1;
  for (int i = 0; i < 3; ++i) {
    const double x = moments[i];
    const double y = moments[(i + 1) % 3];
    nearest = std::min(nearest, std::abs(x - y) / std::max(x, y));
  }
  return nearest;
}

}  // namespace

std::vector<Near> near_orientations() {
  return {
      of_quaternion(
          "orientation_unit", [](const Q& q) { return std::abs(length_of(q) - 1); },
          [](Stream& stream, Q& q, double distance) { q *= stream.chance(2) ? 1 + distance : 1 - distance; }),
      of_quaternion(
          "orientation_identity", [](const Q& q) { return length_of(q - Q(1, 0, 0, 0)); }, turn_slightly),
      of_quaternion(
          "orientation_long_identity", [](const Q& q) { return q[0] > 0 ? length(axis_of(q)) / q[0] : 0; },
          turn_slightly),
      of_quaternion(
          "orientation_negated_identity", [](const Q& q) { return q[0] < 0 ? length(axis_of(q)) / -q[0] : 0; },
          turn_slightly),
      of_quaternion(
          "orientation_half_turn", [](const Q& q) { return std::abs(q[0]) / length_of(q); },
          [](Stream& stream, Q& q, double distance) {
            const double w = distance * length_of(q);
            q[0] = stream.chance(2) ? w : -w;
          }),
      of_quaternion(
          "orientation_half_turn_about_axis",
          [](const Q& q) { return length_of(without(q, place_of_axis(q))) / length_of(q); }, move_quaternion),
      of_quaternion(
          "orientation_quarter_turn",
          [](const Q& q) {
            const int place = place_of_axis(q);
            Q rest = without(q, place);
            rest[0] = std::abs(q[0]) - std::abs(q[place]);
            return length_of(rest) / length_of(q);
          },
          [](Stream& stream, Q& q, double distance) {
            q[0] = std::copysign(q[place_of_axis(q)], q[0]);
            move_quaternion(stream, q, distance);
          }),
      of_quaternion(
          "orientation_about_axis",
          [](const Q& q) {
            const double of_axis = length(axis_of(q));
            return of_axis == 0 ? 0 : length_of(without(without(q, place_of_axis(q)), 0)) / of_axis;
          },
          [](Stream& stream, Q& q, double distance) {
            const double w = q[0];
            const Q by = some_quaternion(stream) * (distance * length(axis_of(q)));
            q += by;
            q[0] = w;
          }),
  };
}

std::vector<Near> near_inertia() {
  return {
      {"mass_one", [](const Collision&, const Body& b) { return b.immovable ? 0 : std::abs(b.mass - 1); },
       [](Stream& stream, Collision&, Body& b, double distance) {
         scale_mass(b, stream.chance(2) ? 1 + distance : 1 - distance);
       }},
      // A body is nearly immovable if it is far heavier than the other one.
      {nullptr,
       [](const Collision& c, const Body&) {
         return c.a.immovable || c.b.immovable ? 0 : std::min(c.a.mass, c.b.mass) / std::max(c.a.mass, c.b.mass);
       },
       [](Stream& stream, Collision& c, Body&, double distance) {
         make_both_movable(stream, c);
         Body& heavy = stream.chance(2) ? c.a : c.b;
         Body& light = &heavy == &c.a ? c.b : c.a;
         constexpr double most = largest_mass / 4;
         scale_mass(light, std::min(1.0, most * distance / light.mass));
         scale_mass(heavy, light.mass / distance / heavy.mass);
       },
       "near_immovable", "one body is immovable, because it is far heavier than the other one"},
      of_moments(
          "moments_equal", [](const V& moments) { return (greatest(moments) - least(moments)) / greatest(moments); },
          [](Stream& stream, V& moments, double distance) {
            const int first = stream.integer(0, 2);
            moments[first] *= 1 - distance;
            moments[(first + 1) % 3] *= 1 - distance * stream.unit();
          }),
      of_moments("moments_two_equal", distance_from_equal_pair,
                 [](Stream& stream, V& moments, double distance) {
                   int first = 0;
                   while (first < 2 && moments[first] != moments[(first + 1) % 3]) {
                     ++first;
                   }
                   moments[first] *= stream.chance(2) ? 1 + distance : 1 - distance;
                 }),
      of_moments(
          "moments_one", [](const V& moments) { return greatest((moments - V(1, 1, 1)).cwiseAbs()); },
          [](Stream& stream, V& moments, double distance) {
            moments += stream.vector() * distance;
            const int furthest = stream.integer(0, 2);
            moments[furthest] = stream.chance(2) ? 1 + distance : 1 - distance;
          }),
      // From below, because no body has a moment above the sum of the others.
      of_moments(
          "flat", [](const V& moments) { return (sum(moments) - 2 * greatest(moments)) / greatest(moments); },
          [](Stream&, V& moments, double distance) { moments[place_of_least(negated(moments))] *= 1 - distance; }),
  };
}

}  // namespace carom::properties::features
