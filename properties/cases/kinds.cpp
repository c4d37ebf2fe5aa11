// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/properties/cases/kinds.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties {
namespace {

using V = Vector3<double>;

struct KindFacts {
  std::string_view name;
  std::array<std::string_view, 4> values;  // in the order of the enumeration, without `any`; the rest is empty
};
constexpr KindFacts of_bodies{"bodies", {"spheres", "solid_spheres"}};
constexpr KindFacts of_movable{"movable", {"both", "one", "a", "b"}};
constexpr KindFacts of_walls{"walls", {"resting"}};
constexpr KindFacts of_plane{"plane", {"xy", "yz", "zx"}};
constexpr std::array all_kind_names{of_bodies.name, of_movable.name, of_walls.name, of_plane.name};

/// Calls use(facts, value) for each kind.
template <class K, class Use>
void for_each_kind(K& kinds, const Use& use) {
  use(of_bodies, kinds.bodies);
  use(of_movable, kinds.movable);
  use(of_walls, kinds.walls);
  use(of_plane, kinds.plane);
}

template <class Use>
void for_each_movable(Collision& c, const Use& use) {
  for (Body* body : {&c.a, &c.b}) {
    if (!body->immovable) {
      use(*body);
    }
  }
}

/// Whether r = P − X of a movable body lies along N, from X outwards: ‖r × N‖ ≤ (2u (‖P‖ + ‖X‖) + 4u ‖r‖) ‖N‖. If
/// decimals are read as P, X and N, rounding causes at most u (‖P‖ + ‖X‖ + ‖r‖). If P = X + R N/‖N‖ is computed, it
/// causes at most u (‖P‖ + ‖r‖). Both are at most 2u (‖P‖ + ‖X‖). This formula has four roundings more: of r, of a
/// product (in two terms), and of a difference. A solid sphere has J = 2/5 m ‖r‖² up to 2/5 m ‖r‖ (4u (‖P‖ + ‖X‖) + 12u
/// ‖r‖): the same rounding of r counts twice, and four roundings of J and eight of this formula are added.
bool is_sphere(const Collision& c, const Body& body, bool is_solid) {
  constexpr double roundoff = 0x1p-53;  // u
  const V& moments = body.principal_inertia;
  const auto largest = [](const V& v) { return greatest(v.cwiseAbs()); };
  const double extent = std::max(largest(c.point), largest(body.position));
  if (moments[0] != moments[1] || moments[1] != moments[2] || extent == 0) {
    return false;
  }
  // Powers of two keep the squares in range.
  const auto scaled = [](const V& v, int exponent) {
    return V(v.unaryExpr([&](double x) { return std::ldexp(x, -exponent); }));
  };
  const int exponent = std::ilogb(extent);
  const V point = scaled(c.point, exponent);
  const V centre = scaled(body.position, exponent);
  const V normal = scaled(c.normal, std::ilogb(largest(c.normal)));
  const V r = point - centre;
  const double radius = length(r);
  const double of_positions = 2 * roundoff * (length(point) + length(centre));
  const double along = dot(r, normal);
  const double solid = 0.4 * body.mass * radius;
  return (&body == &c.a ? along < 0 : along > 0) &&
         length(cross(r, normal)) <= (of_positions + 4 * roundoff * radius) * length(normal) &&
         (!is_solid || std::abs(std::ldexp(moments[0], -2 * exponent) - solid * radius) <=
                           solid * (2 * of_positions + 12 * roundoff * radius));
}

/// Whether the lever arms of the spheres lie exactly along the normal.
bool are_exact(const Kinds& kinds, const Collision& c) {
  const auto is_one = [&](const Body& body) {
    return body.immovable ||
           (features::are_parallel(features::lever_arm(c, body), c.normal) && features::is_exact_lever_arm(c, body));
  };
  return kinds.bodies == Bodies::any || (is_one(c.a) && is_one(c.b));
}

bool are_spheres(const Kinds& kinds, const Collision& c) {
  const auto is_one = [&](const Body& body) {
    return body.immovable || is_sphere(c, body, kinds.bodies == Bodies::solid_spheres);
  };
  return kinds.bodies == Bodies::any || (is_one(c.a) && is_one(c.b));
}

bool are_movable_as(Movable movable, const Collision& c) {
  switch (movable) {
    case Movable::any:
      break;
    case Movable::both:
      return !c.a.immovable && !c.b.immovable;
    case Movable::one:
      return c.a.immovable != c.b.immovable;
    case Movable::a:
      return !c.a.immovable && c.b.immovable;
    case Movable::b:
      return c.a.immovable && !c.b.immovable;
  }
  return true;
}

/// Whether this body axis lies along the world axis of the same name, in either direction.
bool turns_about(const Body& body, int axis) {
  const auto& q = body.orientation;
  const double next = q[1 + (axis + 1) % 3];
  const double last = q[1 + (axis + 2) % 3];
  return (next == 0 && last == 0) || (q[0] == 0 && q[1 + axis] == 0);
}

bool are_in_plane(const Kinds& kinds, const Collision& c) {
  const std::optional<int> axis = normal_axis(kinds);
  const auto is_in_plane = [&](const Body& body) {
    const V& w = body.angular_velocity;
    return body.position[*axis] == 0 && body.velocity[*axis] == 0 && w[(*axis + 1) % 3] == 0 &&
           w[(*axis + 2) % 3] == 0 && (body.immovable || turns_about(body, *axis));
  };
  return !axis || (c.point[*axis] == 0 && c.normal[*axis] == 0 && is_in_plane(c.a) && is_in_plane(c.b));
}

/// The body becomes a wall, at rest or with its motion. At rest, the other body gets its relative velocity.
void make_wall(Stream& stream, Body& body, Body& other) {
  Body wall = body;
  make_immovable(body);
  if (stream.chance(2)) {
    other.velocity -= wall.velocity;
  } else {
    body.velocity = wall.velocity;
    body.angular_velocity = wall.angular_velocity;
  }
}

/// Returns whether a body became movable.
bool make_movable_as(Movable movable, Stream& stream, Collision& c) {
  if (are_movable_as(movable, c)) {
    return false;
  }
  const bool were_walls = c.a.immovable && c.b.immovable;
  const bool are_both = movable == Movable::both;
  const bool is_a = movable == Movable::a || (movable == Movable::one && stream.chance(2));
  Body& moved = is_a ? c.a : c.b;
  Body& other = is_a ? c.b : c.a;
  if (are_both) {
    features::make_movable(stream, c, c.a);
    features::make_movable(stream, c, c.b);
  } else if (were_walls) {
    features::make_movable(stream, c, moved);
  } else if (moved.immovable) {
    std::swap(c.a, c.b);
    c.normal = negated(c.normal);
  } else {
    make_wall(stream, other, moved);
  }
  return are_both || were_walls;
}

/// The other body keeps its relative velocity.
void stop_walls(const Kinds& kinds, Collision& c) {
  const Vector3<double> of_wall = c.a.immovable ? c.a.velocity : c.b.immovable ? c.b.velocity : V(V::Zero());
  if (kinds.walls == Walls::resting) {
    c.a.velocity -= of_wall;
    c.b.velocity -= of_wall;
    stop_outside({.walls = Walls::resting}, c);
  }
}

/// The lever arm of a body that is turned so that its axis lies along the world's. A contact stays where it is in the
/// body, except that it moves along this axis. So it gets no further outside.
V arm_in_plane(const Collision& c, Body& body, int axis) {
  V r = features::lever_arm(c, body);
  if (!body.immovable && !turns_about(body, axis)) {
    const Quaternion<double> drawn = body.orientation;
    for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
      body.orientation[1 + other] = 0;
    }
    const V& moments = body.principal_inertia;
    if (moments[0] != moments[1] || moments[1] != moments[2]) {
      V in_body = turned(conjugate(drawn), r);
      in_body[axis] = 0;
      r = turned(body.orientation, in_body);
    }
  }
  r[axis] = 0;
  return r;
}

/// Returns whether a movable body turned, or the contact moved on it.
bool put_in_plane(const Kinds& kinds, Collision& c) {
  if (are_in_plane(kinds, c)) {
    return false;
  }
  const int axis = *normal_axis(kinds);
  while (features::is_zero(in_plane(kinds, c.normal))) {
    rename_axes(c);
  }
  const std::array arms{arm_in_plane(c, c.a, axis), arm_in_plane(c, c.b, axis)};
  c.normal[axis] = 0;
  c.point[axis] = 0;
  for (Body* body : {&c.a, &c.b}) {
    body->position[axis] = 0;
    const V& arm = arms[body == &c.a ? 0 : 1];
    if (features::lever_arm(c, *body) != arm) {
      features::set_lever_arm(c, *body, arm);
    }
    V& v = body->velocity;
    V& w = body->angular_velocity;
    v[(axis + 1) % 3] = features::is_zero(in_plane(kinds, v)) ? v[axis] : v[(axis + 1) % 3];
    w[axis] = w[axis] == 0 && !features::is_zero(w) ? features::size_of(w) : w[axis];
  }
  stop_outside(kinds, c);
  return true;
}

/// Turns lever arms exactly along the normal, and makes moments equal. Mostly rounds the normal, because otherwise the
/// contact would be at the origin.
bool make_spheres(const Kinds& kinds, Stream& stream, Collision& c) {
  if (are_spheres(kinds, c) && are_exact(kinds, c)) {
    return false;
  }
  constexpr int short_bits = 20;
  const V shortened = c.normal.unaryExpr([](double x) { return rounded_to_bits(x, short_bits); });
  if (shortened != c.normal && !stream.chance(8)) {
    c.normal = features::with_few_bits(c.normal);
  }
  for_each_movable(c, [&](Body& body) {
    V r = features::lever_arm(c, body);
    if (features::is_zero(r)) {
      r = V::Unit(0) * features::radius_of_gyration(body);
    }
    r = features::turned_along(r, &body == &c.a ? negated(c.normal) : c.normal);
    features::set_exact_lever_arm(c, body, r);
  });
  for_each_movable(c, [&](Body& body) {
    V& moments = body.principal_inertia;
    const double square = body.mass * squared_length(features::lever_arm(c, body));
    const bool is_solid = kinds.bodies == Bodies::solid_spheres || (!is_sphere(c, body, false) && stream.chance(2));
    // With at least m ‖r‖² / 4, the contact is not outside of the body (`features::overreach`).
    moments.setConstant(is_solid ? 0.4 * square : std::max(greatest(moments), square / 4));
  });
  return true;
}

/// The sign of N·V, rounded.
int direction_of(const Collision& c) {
  const double along = dot(c.normal, relative_velocity(c));
  return along > 0 ? 1 : along < 0 ? -1 : 0;
}

}  // namespace

std::span<const std::string_view> kind_names() { return all_kind_names; }

const std::vector<KindText>& all_kinds() {
  static const std::vector<KindText> all = [] {
    std::vector<KindText> texts;
    const Kinds any;
    for_each_kind(any, [&](const KindFacts& facts, auto) {
      for (const std::string_view value : facts.values) {
        if (!value.empty()) {
          texts.emplace_back(facts.name, value);
        }
      }
    });
    return texts;
  }();
  return all;
}

std::vector<KindText> texts_of(const Kinds& kinds) {
  std::vector<KindText> texts;
  for_each_kind(kinds, [&](const KindFacts& facts, auto value) {
    if (const auto place = static_cast<std::size_t>(value); place > 0) {
      texts.emplace_back(facts.name, facts.values.at(place - 1));
    }
  });
  return texts;
}

void set_kind(Kinds& kinds, std::string_view name, std::string_view text) {
  for_each_kind(kinds, [&](const KindFacts& facts, auto& value) {
    if (facts.name != name) {
      return;
    }
    const auto end = std::ranges::find(facts.values, std::string_view());
    const auto found = std::find(facts.values.begin(), end, text);
    if (found == end) {
      throw std::invalid_argument(
          fmt::format("{}: expected one of {}, found '{}'", name, fmt::join(facts.values.begin(), end, ", "), text));
    }
    value = static_cast<std::remove_reference_t<decltype(value)>>(found - facts.values.begin() + 1);
  });
}

std::optional<std::string_view> kind_outside(const Kinds& kinds, const Collision& c) {
  if (!are_spheres(kinds, c)) {
    return of_bodies.name;
  }
  if (!are_movable_as(kinds.movable, c)) {
    return of_movable.name;
  }
  const auto is_moving_wall = [](const Body& body) { return body.immovable && !features::is_at_rest(body); };
  if (kinds.walls == Walls::resting && (is_moving_wall(c.a) || is_moving_wall(c.b))) {
    return of_walls.name;
  }
  return are_in_plane(kinds, c) ? std::nullopt : std::optional(of_plane.name);
}

bool put_into(const Kinds& kinds, Stream& stream, Collision& c) {
  if (!kind_outside(kinds, c) && are_exact(kinds, c)) {
    return false;
  }
  const int drawn = direction_of(c);
  bool is_changed = make_movable_as(kinds.movable, stream, c);
  stop_walls(kinds, c);
  is_changed = put_in_plane(kinds, c) || is_changed;
  is_changed = make_spheres(kinds, stream, c) || is_changed;
  if (drawn != 0 && direction_of(c) == -drawn) {
    for (Body* body : {&c.a, &c.b}) {
      body->velocity = negated(body->velocity);
      body->angular_velocity = negated(body->angular_velocity);
    }
  }
  return is_changed;
}

void stop_outside(const Kinds& kinds, Collision& c) {
  const std::optional<int> axis = normal_axis(kinds);
  for (Body* body : {&c.a, &c.b}) {
    if (axis) {
      body->velocity[*axis] = 0;
      body->angular_velocity[(*axis + 1) % 3] = 0;
      body->angular_velocity[(*axis + 2) % 3] = 0;
    }
    if (body->immovable && kinds.walls == Walls::resting) {
      body->velocity.setZero();
      body->angular_velocity.setZero();
    }
  }
}

void rename_axes(Collision& c) {
  const auto renamed = [](const V& v) { return V{v[2], v[0], v[1]}; };
  for (V* v : {&c.point, &c.normal}) {
    *v = renamed(*v);
  }
  for (Body* body : {&c.a, &c.b}) {
    for (V* v : {&body->position, &body->velocity, &body->angular_velocity, &body->principal_inertia}) {
      *v = renamed(*v);
    }
    body->orientation.tail<3>() = renamed(V(body->orientation.tail<3>()));
  }
}

std::optional<int> normal_axis(const Kinds& kinds) {
  switch (kinds.plane) {
    case Plane::any:
      break;
    case Plane::xy:
      return 2;
    case Plane::yz:
      return 0;
    case Plane::zx:
      return 1;
  }
  return std::nullopt;
}

Vector3<double> in_plane(const Kinds& kinds, Vector3<double> v) {
  if (const std::optional<int> axis = normal_axis(kinds)) {
    v[*axis] = 0;
  }
  return v;
}

}  // namespace carom::properties
