// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;
using Q = Quaternion<double>;

/// A vector of this length.
V some_vector(Stream& stream, double size) {
  const V direction = stream.direction();
  return direction * (size / length(direction));
}

/// Moves the lever arm of a body by this share of its length.
void move_lever_arm(Stream& stream, Collision& c, Body& b, double distance) {
  const V r = lever_arm(c, b);
  set_exact_lever_arm(c, b, r + some_vector(stream, distance * length(r)));
}

V speed_by_spin(const Collision& c, const Body& b) { return cross(b.angular_velocity, lever_arm(c, b)); }

/// The relative velocity without this part of the body's velocity.
V rest_of_approach(const Collision& c, const Body& b, const V& part) {
  const V v = relative_velocity(c);
  return &b == &c.a ? V(v - part) : V(v + part);
}

double distance_of_velocity(const Collision& c, const Body& b) {
  return ratio(length(b.velocity), length(rest_of_approach(c, b, b.velocity)));
}
double distance_of_spin(const Collision& c, const Body& b) {
  return ratio(length(b.angular_velocity) * length(lever_arm(c, b)),
               length(rest_of_approach(c, b, speed_by_spin(c, b))));
}

/// Both bodies have the vector, equal or opposite.
Near pair_of_vectors(const char* of, V Body::*vector, double sign) {
  return {of,
          [=](const Collision& c, const Body&) {
            return ratio(length(c.a.*vector - c.b.*vector * sign), length(c.a.*vector));
          },
          [=](Stream& stream, Collision& c, Body&, double distance) {
            V& moved = stream.chance(2) ? c.a.*vector : c.b.*vector;
            moved += some_vector(stream, distance * length(moved));
          }};
}

Near pair_of_orientations(const char* of, double sign) {
  return {of,
          [=](const Collision& c, const Body&) {
            const Q difference = c.a.orientation - c.b.orientation * sign;
            return c.a.immovable || c.b.immovable
                       ? 0
                       : std::sqrt(squared_length(difference) / squared_length(c.a.orientation));
          },
          [=](Stream& stream, Collision& c, Body&, double distance) {
            const Q by = stream.quaternion();
            c.b.orientation += by * (distance * std::sqrt(squared_length(c.b.orientation) / squared_length(by)));
          }};
}

double distance_of_masses(const Collision& c) { return std::abs(c.a.mass - c.b.mass) / std::max(c.a.mass, c.b.mass); }
double distance_of_moments(const Collision& c) {
  return greatest((c.a.principal_inertia - c.b.principal_inertia).cwiseAbs()) / greatest(c.a.principal_inertia);
}

void move_masses(Stream& stream, Collision& c, double distance) {
  scale_mass(c.b, stream.chance(2) ? 1 + distance : 1 - distance);
}
void move_moments(Stream& stream, Collision& c, double distance) {
  for (int i = 0; i < 3; ++i) {
    c.b.principal_inertia[i] *= 1 + distance * stream.signed_unit();
  }
  c.b.principal_inertia[stream.integer(0, 2)] *= stream.chance(2) ? 1 + distance : 1 - distance;
}

/// The share of v that lies across the plane z = const.
double share_across(const V& v) { return ratio(std::abs(v[2]), length(v)); }
/// The share of v that lies in the plane z = const.
double share_in(V v) {
  const double whole = length(v);
  v[2] = 0;
  return ratio(length(v), whole);
}

double distance_from_plane(const Collision& c) {
  double furthest = share_across(c.normal);
  for (const Body* b : {&c.a, &c.b}) {
    const Q& q = b->orientation;
    const double of_turn = b->immovable ? 0 : share_in(V(q[1], q[2], q[3] == 0 ? q[0] : q[3]));
    furthest = std::max(
        {furthest, share_across(lever_arm(c, *b)), share_across(b->velocity), share_in(b->angular_velocity), of_turn});
  }
  return furthest;
}

void move_out_of_plane(Stream& stream, Collision& c, double distance) {
  c.normal[2] = distance * length(c.normal);
  for (Body* b : {&c.a, &c.b}) {
    b->position[2] += distance * stream.signed_unit() * length(lever_arm(c, *b));
    b->velocity[2] = distance * stream.signed_unit() * length(b->velocity);
    const V out = stream.vector() * (distance * length(b->angular_velocity));
    b->angular_velocity[0] = out[0];
    b->angular_velocity[1] = out[1];
    b->orientation[1] = distance * stream.signed_unit() * std::abs(b->orientation[3]);
  }
}

}  // namespace

std::vector<Near> near_zeros() {
  return {
      {"at_origin",
       [](const Collision& c, const Body& b) { return ratio(length(b.position), length(lever_arm(c, b))); },
       [](Stream& stream, Collision& c, Body& b, double distance) {
         b.position = some_vector(stream, distance * length(c.point));
       }},
      {"lever_arm_zero",
       [](const Collision& c, const Body& b) {
         const double size = b.immovable ? least_radius_of_gyration(c) : radius_of_gyration(b);
         return ratio(length(lever_arm(c, b)), size);
       },
       [](Stream& stream, Collision& c, Body& b, double distance) {
         const double size = b.immovable ? least_radius_of_gyration(c) : radius_of_gyration(b);
         set_exact_lever_arm(c, b, some_vector(stream, distance * size));
       }},
      {"velocity_zero", distance_of_velocity,
       [](Stream& stream, Collision& c, Body& b, double distance) {
         b.velocity = some_vector(stream, distance * length(relative_velocity(c)));
       }},
      {"spin_zero", distance_of_spin,
       [](Stream& stream, Collision& c, Body& b, double distance) {
         const double size = ratio(distance * length(relative_velocity(c)), length(lever_arm(c, b)));
         b.angular_velocity = some_vector(stream, size);
       }},
      {"at_rest",
       [](const Collision& c, const Body& b) {
         const double rest = length(rest_of_approach(c, b, b.velocity + speed_by_spin(c, b)));
         const double by_spin = length(b.angular_velocity) * length(lever_arm(c, b));
         return ratio(std::max(length(b.velocity), by_spin), rest);
       },
       [](Stream& stream, Collision& c, Body& b, double distance) {
         const double speed = distance * length(relative_velocity(c));
         b.velocity = some_vector(stream, speed);
         b.angular_velocity = some_vector(stream, ratio(speed, length(lever_arm(c, b))));
       }},
      {"approach_by_spin",
       [](const Collision& c, const Body&) {
         const double by_spin = length(speed_by_spin(c, c.a) - speed_by_spin(c, c.b));
         return ratio(std::max(length(c.a.velocity), length(c.b.velocity)), by_spin);
       },
       [](Stream& stream, Collision& c, Body&, double distance) {
         const double speed = distance * length(relative_velocity(c));
         c.a.velocity = some_vector(stream, speed);
         c.b.velocity = some_vector(stream, speed);
       }},
      {"point_at_origin",
       [](const Collision& c, const Body&) {
         return ratio(length(c.point), std::max(length(c.a.position), length(c.b.position)));
       },
       [](Stream& stream, Collision& c, Body&, double distance) {
         c.point = some_vector(stream, distance * std::max(length(c.a.position), length(c.b.position)));
       }},
  };
}

std::vector<Near> near_pairs() {
  return {
      {"masses_equal",
       [](const Collision& c, const Body&) { return c.a.immovable || c.b.immovable ? 0 : distance_of_masses(c); },
       [](Stream& stream, Collision& c, Body&, double distance) { move_masses(stream, c, distance); }},
      {"moments_alike",
       [](const Collision& c, const Body&) { return c.a.immovable || c.b.immovable ? 0 : distance_of_moments(c); },
       [](Stream& stream, Collision& c, Body&, double distance) { move_moments(stream, c, distance); }},
      {"bodies_alike",
       [](const Collision& c, const Body&) {
         return c.a.immovable || c.b.immovable ? 0 : std::max(distance_of_masses(c), distance_of_moments(c));
       },
       [](Stream& stream, Collision& c, Body&, double distance) {
         move_masses(stream, c, distance);
         move_moments(stream, c, distance);
       }},
      pair_of_orientations("orientations_equal", 1),
      pair_of_orientations("orientations_opposite", -1),
      pair_of_vectors("velocities_equal", &Body::velocity, 1),
      pair_of_vectors("velocities_opposite", &Body::velocity, -1),
      pair_of_vectors("spins_equal", &Body::angular_velocity, 1),
      pair_of_vectors("spins_opposite", &Body::angular_velocity, -1),
      {"momenta_opposite",
       [](const Collision& c, const Body&) {
         const V of_a = c.a.velocity * c.a.mass;
         return c.a.immovable || c.b.immovable ? 0 : ratio(length(of_a + c.b.velocity * c.b.mass), length(of_a));
       },
       [](Stream& stream, Collision& c, Body&, double distance) {
         c.b.velocity += some_vector(stream, distance * length(c.b.velocity));
       }},
      {"lever_arms_opposite",
       [](const Collision& c, const Body&) {
         return ratio(length(lever_arm(c, c.a) + lever_arm(c, c.b)), length(lever_arm(c, c.a)));
       },
       [](Stream& stream, Collision& c, Body&, double distance) { move_lever_arm(stream, c, c.b, distance); }},
      {"centres_coincide",
       [](const Collision& c, const Body&) {
         return ratio(length(c.a.position - c.b.position), length(lever_arm(c, c.a)));
       },
       [](Stream& stream, Collision& c, Body&, double distance) { move_lever_arm(stream, c, c.b, distance); }},
  };
}

std::vector<Near> near_relations() {
  return {
      {"central",
       [](const Collision& c, const Body&) {
         const auto from_normal = [&](const Body& b) {
           const V r = lever_arm(c, b);
           return ratio(length(cross(r, c.normal)), length(r) * length(c.normal));
         };
         return std::max(from_normal(c.a), from_normal(c.b));
       },
       [](Stream& stream, Collision& c, Body&, double distance) {
         for (Body* b : {&c.a, &c.b}) {
           move_lever_arm(stream, c, *b, distance);
         }
       }},
      {"spin_equals_velocity",
       [](const Collision&, const Body& b) {
         return ratio(length(b.velocity - b.angular_velocity), length(b.velocity));
       },
       [](Stream& stream, Collision&, Body& b, double distance) {
         b.angular_velocity += some_vector(stream, distance * length(b.velocity));
       }},
      {"rolling",
       [](const Collision& c, const Body& b) {
         return ratio(length(b.velocity + speed_by_spin(c, b)), length(b.velocity));
       },
       [](Stream& stream, Collision&, Body& b, double distance) {
         b.velocity += some_vector(stream, distance * length(b.velocity));
       }},
      {"planar", [](const Collision& c, const Body&) { return distance_from_plane(c); },
       [](Stream& stream, Collision& c, Body&, double distance) { move_out_of_plane(stream, c, distance); }},
  };
}

}  // namespace carom::properties::features
