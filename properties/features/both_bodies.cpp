// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;

/// Gives B the moments of A. Scales B's lever arm by a power of two near the ratio of B's new size to its old size.
void take_moments(Collision& c) {
  const double size = radius_of_gyration(c.b);
  c.b.principal_inertia = c.a.principal_inertia;
  int exponent = 0;
  std::frexp(radius_of_gyration(c.b) / size, &exponent);
  set_lever_arm(c, c.b, lever_arm(c, c.b) * std::ldexp(1.0, exponent - 1));
}

/// Sets one vector to `sign` times the other. If both are zero, the other first becomes `otherwise`.
void relate(Stream& stream, V& x, V& y, double sign, const V& otherwise) {
  V& follows = is_zero(x) || (!is_zero(y) && stream.chance(2)) ? x : y;
  V& leads = &follows == &x ? y : x;
  if (is_zero(leads)) {
    leads = otherwise;
  }
  follows = leads * sign;
}

/// Both bodies have the vector, equal or opposite, and not zero.
Feature both_have(const char* name, const char* statement, const char* why, V Body::*vector, double sign) {
  return pair_relation(
      name, statement, why,
      [=](const Collision& c) { return c.a.*vector == c.b.*vector * sign && !is_zero(c.a.*vector); },
      [=](Stream& stream, Collision& c) {
        relate(stream, c.a.*vector, c.b.*vector, sign, V{1, -0.5, 0.25});
      });
}

/// One of the two lever arms, mostly the shorter. If it is zero, a short vector along the normal.
V one_lever_arm(Stream& stream, const Collision& c) {
  const V of_a = lever_arm(c, c.a);
  const V of_b = lever_arm(c, c.b);
  const bool wanted = !stream.chance(4);
  const V& chosen = (squared_length(of_b) < squared_length(of_a)) == wanted ? of_b : of_a;
  if (!is_zero(chosen)) {
    return with_few_bits(chosen);
  }
  const double size = std::max(size_of(of_a), size_of(of_b));
  return with_few_bits(c.normal) * (size / 1024 / size_of(c.normal));
}

V rounded(const V& v) {
  const auto whole = [](double x) { return std::round(x); };
  return v.unaryExpr(whole);
}

/// Rounds every number of the body to an integer. A body below 1 kg or 1 m grows. A small body with the contact at its
/// centre of mass gains mass in place of size.
void make_whole_body(Stream& stream, Collision& c, Body& b) {
  const V r = rounded(lever_arm(c, b));
  b.position = rounded(c.point) - r;
  b.velocity = rounded(b.velocity);
  b.angular_velocity = rounded(b.angular_velocity);
  if (b.immovable) {
    return;
  }
  const double size = is_zero(r) ? radius_of_gyration(b) : std::max({1.0, length(r), radius_of_gyration(b)});
  const V shape = b.principal_inertia / (b.mass * radius_of_gyration(b) * radius_of_gyration(b));
  b.mass = std::round(std::clamp(4 / (size * size), std::max(1.0, b.mass), largest_mass / 2));
  b.principal_inertia = rounded(shape * (b.mass * size * size)).cwiseMax(1);
  for (int i = 0; i < 4; ++i) {
    b.orientation[i] = stream.integer(-2, 2);
  }
  if ((b.orientation.array() == 0).all()) {
    b.orientation[0] = 1;
  }
}

void make_whole(Stream& stream, Collision& c) {
  make_whole_body(stream, c, c.a);
  make_whole_body(stream, c, c.b);
  c.point = rounded(c.point);
  c.normal = rounded(c.normal * std::max(1.0, 8 / size_of(c.normal)));
  if (stream.chance(4)) {
    // The normal and the velocity are almost orthogonal, with integer components.
    const int across = stream.integer(0, 2);
    c.normal.setZero();
    c.normal[across] = stream.power_of_two(1, 33);
    c.normal[(across + 1) % 3] = 1;
    c.a.velocity = negated(V(V::Unit((across + 1) % 3)));
    c.a.angular_velocity.setZero();
    c.b.angular_velocity.setZero();
    c.b.velocity.setZero();
  }
  c.restitution = std::round(c.restitution);
  c.friction = std::round(c.friction);
  c.tangential_restitution = std::round(c.tangential_restitution);
}

/// Puts everything into the plane z = 0, as in a two-dimensional engine.
void make_planar(Stream& stream, Collision& c) {
  if (c.normal[0] == 0 && c.normal[1] == 0) {
    c.normal[stream.integer(0, 1)] = size_of(c.normal);
  }
  c.normal[2] = 0;
  c.point[2] = 0;
  for (Body* b : {&c.a, &c.b}) {
    b->position[2] = 0;
    b->velocity[2] = 0;
    b->angular_velocity[0] = 0;
    b->angular_velocity[1] = 0;
    b->orientation[1] = 0;
    b->orientation[2] = 0;
    if (b->orientation[0] == 0 && b->orientation[3] == 0) {
      b->orientation[0] = 1;
    }
  }
}

bool is_planar(const Collision& c) {
  const auto in_plane = [&](const Body& b) {
    return b.position[2] == c.point[2] && b.velocity[2] == 0 && b.angular_velocity[0] == 0 &&
           b.angular_velocity[1] == 0 && (b.immovable || (b.orientation[1] == 0 && b.orientation[2] == 0));
  };
  return c.normal[2] == 0 && in_plane(c.a) && in_plane(c.b);
}

bool is_whole(const Collision& c) {
  bool whole = true;
  Collision copy = c;
  for_each_number([&](const FieldPath&, const double& number) { whole = whole && number == std::floor(number); }, copy);
  return whole;
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Feature> of_both_bodies() {
  return {
      pair_relation(
          "masses_equal", "both masses are equal", "m_A − m_B vanishes; the bodies exchange velocities",
          [](const Collision& c) { return are_movable(c) && c.a.mass == c.b.mass; },
          [](Stream& stream, Collision& c) {
            make_both_movable(stream, c);
            set_mass(c.b, c.a.mass);
          }),
      pair_relation(
          "moments_alike", "both bodies have the same moments", "the moments of the two bodies may be confused",
          [](const Collision& c) { return are_movable(c) && c.a.principal_inertia == c.b.principal_inertia; },
          [](Stream& stream, Collision& c) {
            make_both_movable(stream, c);
            take_moments(c);
          }),
      pair_relation(
          "bodies_alike", "both bodies have the same mass and the same moments",
          "nearly all scenes contain identical bodies",
          [](const Collision& c) {
            return are_movable(c) && c.a.mass == c.b.mass && c.a.principal_inertia == c.b.principal_inertia;
          },
          [](Stream& stream, Collision& c) {
            make_both_movable(stream, c);
            set_mass(c.b, c.a.mass);
            take_moments(c);
          }),
      pair_relation(
          "orientations_equal", "both orientations are equal",
          "boxes on a grid; a solver may assume that there is no relative rotation",
          [](const Collision& c) { return are_movable(c) && c.a.orientation == c.b.orientation; },
          [](Stream& stream, Collision& c) {
            make_both_movable(stream, c);
            (stream.chance(2) ? c.b.orientation = c.a.orientation : c.a.orientation = c.b.orientation);
          }),
      pair_relation(
          "orientations_opposite", "q_B = −q_A", "q and −q are the same rotation",
          [](const Collision& c) { return are_movable(c) && c.a.orientation == negated(c.b.orientation); },
          [](Stream& stream, Collision& c) {
            make_both_movable(stream, c);
            c.b.orientation = negated(c.a.orientation);
          }),
      both_have("velocities_equal", "both velocities are equal and not zero",
                "v_A − v_B vanishes: the bodies approach by spin alone", &Body::velocity, 1),
      pair_relation(
          "velocities_opposite", "v_A = −v_B ≠ 0", "identical bodies that meet: their momenta cancel",
          [](const Collision& c) { return c.a.velocity == negated(c.b.velocity) && !is_zero(c.a.velocity); },
          [](Stream& stream, Collision& c) {
            relate(stream, c.a.velocity, c.b.velocity, -1, V(negated(c.normal) / size_of(c.normal)));
          }),
      both_have("spins_equal", "both angular velocities are equal and not zero", "w_A − w_B vanishes",
                &Body::angular_velocity, 1),
      both_have("spins_opposite", "w_A = −w_B ≠ 0", "gears; w_A + w_B vanishes", &Body::angular_velocity, -1),
      pair_relation(
          "lever_arms_opposite", "r_A = −r_B ≠ 0", "identical bodies; sums of lever arms cancel",
          [](const Collision& c) {
            return !is_zero(lever_arm(c, c.a)) && lever_arm(c, c.a) == negated(lever_arm(c, c.b));
          },
          [](Stream& stream, Collision& c) {
            const V r = one_lever_arm(stream, c);
            set_exact_lever_arm(c, c.a, r);
            set_exact_lever_arm(c, c.b, negated(r));
          }),
      pair_relation(
          "centres_coincide", "both centres of mass coincide, and the contact is elsewhere",
          "a normal that is computed from the centres is zero (failure case 12)",
          [](const Collision& c) { return c.a.position == c.b.position && !is_zero(lever_arm(c, c.a)); },
          [](Stream& stream, Collision& c) {
            set_exact_lever_arm(c, c.a, one_lever_arm(stream, c));
            c.b.position = c.a.position;
          }),
      pair_relation(
          "central", "both lever arms lie along the normal",
          "spheres: an impulse along N does not change their spins (docs/findings/note.md)",
          [](const Collision& c) {
            return are_parallel(lever_arm(c, c.a), c.normal) && are_parallel(lever_arm(c, c.b), c.normal);
          },
          [](Stream&, Collision& c) {
            c.normal = with_few_bits(c.normal);
            set_exact_lever_arm(c, c.a, turned_along(lever_arm(c, c.a), negated(c.normal)));
            set_exact_lever_arm(c, c.b, turned_along(lever_arm(c, c.b), c.normal));
          }),
      pair_relation(
          "point_at_origin", "the contact is at the origin", "P may be missing in a formula",
          [](const Collision& c) { return is_zero(c.point); }, [](Stream&, Collision& c) { move_point_to_origin(c); }),
      pair_relation("whole_numbers", "every number is an integer",
                    "parsers that read integers; results without rounding errors", is_whole, make_whole),
      pair_relation("planar", "the whole collision lies in one plane z = const",
                    "two-dimensional engines and their test scenes", is_planar, make_planar),
  };
}

}  // namespace carom::properties::features
