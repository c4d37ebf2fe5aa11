// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;

/// A vector of the collision or of the body.
struct VectorOf {
  V (*get)(const Collision&, const Body&);
  void (*set)(Collision&, Body&, const V&);
};
constexpr VectorOf arm{lever_arm, set_exact_lever_arm};
constexpr VectorOf velocity{[](const Collision&, const Body& b) { return b.velocity; },
                            [](Collision&, Body& b, const V& v) { b.velocity = v; }};
constexpr VectorOf spin{[](const Collision&, const Body& b) { return b.angular_velocity; },
                        [](Collision&, Body& b, const V& w) { b.angular_velocity = w; }};
constexpr VectorOf normal{[](const Collision& c, const Body&) { return c.normal; },
                          [](Collision& c, Body&, const V& n) { c.normal = n; }};
constexpr VectorOf approach{[](const Collision& c, const Body&) { return relative_velocity(c); },
                            [](Collision& c, Body&, const V& v) { set_relative_velocity(c, v); }};

/// v, moved across itself by this share of its length.
V turned_by(Stream& stream, const V& v, double distance) {
  const V across = cross(v, stream.direction());
  const V direction = is_zero(across) ? orthogonal(v) : across;
  return is_zero(direction) ? v : plus(v, direction, distance * length(v) / length(direction));
}

double distance_from_axis(const V& v) {
  V rest = v;
  rest[place_of_least(negated(V(v.cwiseAbs())))] = 0;
  return ratio(length(rest), length(v));
}

/// The least relative difference of the sizes of two components.
double distance_from_ties(const V& v) {
  double nearest = 1;
  for (int i = 0; i < 3; ++i) {
    const double x = std::abs(v[i]);
    const double y = std::abs(v[(i + 1) % 3]);
    nearest = x == 0 && y == 0 ? nearest : std::min(nearest, std::abs(x - y) / std::max(x, y));
  }
  return nearest;
}

Near along(const char* of, VectorOf u, VectorOf v, const char* name = nullptr) {
  return {of,
          [=](const Collision& c, const Body& b) {
            const V x = u.get(c, b);
            const V y = v.get(c, b);
            return ratio(length(cross(x, y)), length(x) * length(y));
          },
          [=](Stream& stream, Collision& c, Body& b, double distance) {
            u.set(c, b, turned_by(stream, u.get(c, b), distance));
          },
          name};
}

Near across(const char* of, VectorOf u, VectorOf v, const char* name = nullptr, const char* statement = nullptr) {
  return {of,
          [=](const Collision& c, const Body& b) {
            const V x = u.get(c, b);
            const V y = v.get(c, b);
            return ratio(std::abs(dot(x, y)), length(x) * length(y));
          },
          [=](Stream& stream, Collision& c, Body& b, double distance) {
            const V x = u.get(c, b);
            const V y = v.get(c, b);
            const double size = ratio(distance * length(x), length(y));
            u.set(c, b, plus(x, y, stream.chance(2) ? size : -size));
          },
          name, statement};
}

Near along_axis(const char* of, VectorOf u) {
  return {of, [=](const Collision& c, const Body& b) { return distance_from_axis(u.get(c, b)); },
          [=](Stream& stream, Collision& c, Body& b, double distance) {
            u.set(c, b, turned_by(stream, u.get(c, b), distance));
          }};
}

Near in_plane(const char* of, VectorOf u) {
  return {of,
          [=](const Collision& c, const Body& b) {
            const V x = u.get(c, b);
            return ratio(least(x.cwiseAbs()), length(x));
          },
          [=](Stream& stream, Collision& c, Body& b, double distance) {
            V x = u.get(c, b);
            const double size = distance * length(x);
            x[place_of_least(x.cwiseAbs())] = stream.chance(2) ? size : -size;
            u.set(c, b, x);
          }};
}

Near ties(const char* of, VectorOf u) {
  return {of, [=](const Collision& c, const Body& b) { return distance_from_ties(u.get(c, b)); },
          [=](Stream& stream, Collision& c, Body& b, double distance) {
            V x = u.get(c, b);
            int first = 0;
            while (first < 2 && (x[first] == 0 || std::abs(x[first]) != std::abs(x[(first + 1) % 3]))) {
              ++first;
            }
            x[first] *= stream.chance(2) ? 1 + distance : 1 - distance;
            u.set(c, b, x);
          }};
}

}  // namespace

std::vector<Near> near_normals() {
  Near on_axis = along_axis(nullptr, normal);
  on_axis.name = "near_normal_along_axis";
  on_axis.statement = "the normal lies along an axis";
  on_axis.move = [](Stream& stream, Collision& c, Body&, double distance) {
    const double size = size_of(c.normal);
    const V axis = V::Unit(stream.integer(0, 2));
    const double signed_size = stream.chance(2) ? size : -size;
    c.normal = turned_by(stream, V(axis * signed_size), distance);
  };
  Near across_normal = across(nullptr, approach, normal, "near_no_approach", "V⁻ is orthogonal to the normal");
  across_normal.move = [](Stream& stream, Collision& c, Body&, double distance) {
    const V v = relative_velocity(c);
    const V tangent = orthogonal(c.normal) * (length(v) / length(c.normal));
    const double size = distance * length(v) / length(c.normal);
    set_relative_velocity(c, plus(tangent, c.normal, stream.chance(4) ? size : -size));
  };
  return {
      std::move(on_axis),
      in_plane("normal_in_plane", normal),
      ties("normal_ties", normal),
      {"normal_diagonal",
       [](const Collision& c, const Body&) {
         const V sizes = c.normal.cwiseAbs();
         return (greatest(sizes) - least(sizes)) / greatest(sizes);
       },
       [](Stream& stream, Collision& c, Body&, double distance) {
         const int first = stream.integer(0, 2);
         c.normal[first] *= 1 - distance;
         c.normal[(first + 1) % 3] *= 1 - distance * stream.unit();
       }},
      {"normal_unit", [](const Collision& c, const Body&) { return std::abs(length(c.normal) - 1); },
       [](Stream& stream, Collision& c, Body&, double distance) {
         c.normal *= stream.chance(2) ? 1 + distance : 1 - distance;
       }},
      along("head_on", approach, normal, "near_no_slip"),
      std::move(across_normal),
      along_axis("approach_along_axis", approach),
  };
}

std::vector<Near> near_vectors() {
  return {
      along_axis("lever_arm_along_axis", arm),
      in_plane("lever_arm_in_plane", arm),
      along("lever_arm_along_normal", arm, normal),
      across("lever_arm_across_normal", arm, normal),
      along("lever_arm_along_velocity", arm, velocity),
      along_axis("velocity_along_axis", velocity),
      in_plane("velocity_in_plane", velocity),
      ties("velocity_ties", velocity),
      along("velocity_along_normal", velocity, normal),
      across("velocity_across_normal", velocity, normal),
      along_axis("spin_along_axis", spin),
      along("spin_along_normal", spin, normal),
      across("spin_across_normal", spin, normal),
      along("spin_along_lever_arm", spin, arm),
      along("spin_along_velocity", spin, velocity),
  };
}

}  // namespace carom::properties::features
