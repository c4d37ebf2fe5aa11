// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <gmpxx.h>

#include <carom/collision/expects.hpp>
#include <carom/impulse/rotation.hpp>
#include <carom/scene/polyhedra/convex_shape.hpp>

namespace carom::scene {
namespace {

using Points = std::vector<Vector3<double>>;
using Polygon = std::vector<std::size_t>;
using Triangle = std::array<std::size_t, 3>;

using RationalVector = std::array<mpq_class, 3>;

RationalVector difference(const Vector3<double>& left, const Vector3<double>& right) {
  RationalVector result;
  for (int i = 0; i < 3; ++i) {
    result[static_cast<std::size_t>(i)] = mpq_class(left[i]) - mpq_class(right[i]);
  }
  return result;
}

RationalVector cross(const RationalVector& x, const RationalVector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

int exact_side(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c, const Vector3<double>& d) {
  const RationalVector normal = cross(difference(b, a), difference(c, a));
  const RationalVector to_d = difference(d, a);
  return sgn(mpq_class(normal[0] * to_d[0] + normal[1] * to_d[1] + normal[2] * to_d[2]));
}

/// The exact signs of the components of (b − a) × (c − a), all 0 if the three points share a line. Precondition: every
/// number is finite.
Vector3<int> normal_signs(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c) {
  CAROM_EXPECTS(a.allFinite() && b.allFinite() && c.allFinite(), a, b, c);
  const RationalVector normal = cross(difference(b, a), difference(c, a));
  return {sgn(normal[0]), sgn(normal[1]), sgn(normal[2])};
}

}  // namespace

int side_of_plane(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                  const Vector3<double>& d) {
  CAROM_EXPECTS(a.allFinite() && b.allFinite() && c.allFinite() && d.allFinite(), a, b, c, d);
  const Vector3<double> x = b - a;
  const Vector3<double> y = c - a;
  const Vector3<double> z = d - a;
  const double determinant =
      z[0] * (x[1] * y[2] - x[2] * y[1]) + z[1] * (x[2] * y[0] - x[0] * y[2]) + z[2] * (x[0] * y[1] - x[1] * y[0]);
  const double permanent = std::abs(z[0]) * (std::abs(x[1] * y[2]) + std::abs(x[2] * y[1])) +
                           std::abs(z[1]) * (std::abs(x[2] * y[0]) + std::abs(x[0] * y[2])) +
                           std::abs(z[2]) * (std::abs(x[0] * y[1]) + std::abs(x[1] * y[0]));
  const double largest = std::max({x.cwiseAbs().maxCoeff(), y.cwiseAbs().maxCoeff(), z.cwiseAbs().maxCoeff()});
  constexpr double unit_roundoff = 0x1p-53;
  // With the unit roundoff u, roundings cost at most (7 + 56 u) u times the permanent (Shewchuk 1997). An underflow in
  // a product of two differences costs at most 2⁻¹⁰⁷⁴ times the third difference. Under the two conditions below,
  // underflows cost less than 2⁻⁹⁹⁰, which is less than (1 − 56 u) u times the permanent.
  constexpr double relative_error = 8 * unit_roundoff;
  if (permanent > 0x1p-900 && largest < 0x1p+75 && std::abs(determinant) > relative_error * permanent) {
    return determinant > 0 ? 1 : -1;
  }
  return exact_side(a, b, c, d);
}

namespace {

Polygon in_order(const Points& points) {
  Polygon order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return std::lexicographical_compare(points[i].begin(), points[i].end(), points[j].begin(), points[j].end());
  });
  return order;
}

/// The sides of a triangle's plane on which points lie.
struct Sides {
  bool above = false;
  bool below = false;
};

Sides sides_of(const Points& points, const Triangle& t) {
  Sides sides;
  for (const Vector3<double>& point : points) {
    const int side = side_of_plane(points[t[0]], points[t[1]], points[t[2]], point);
    sides.above = sides.above || side > 0;
    sides.below = sides.below || side < 0;
    if (sides.above && sides.below) {
      break;
    }
  }
  return sides;
}

/// Three points of a face, counterclockwise as seen from outside; none if all points share a plane. `corner`, the first
/// point in the order of coordinates, is a corner of the hull, so one of its triangles lies in a face.
std::optional<Triangle> first_triangle(const Points& points, std::size_t corner) {
  for (std::size_t j = 0; j < points.size(); ++j) {
    for (std::size_t k = j + 1; k < points.size(); ++k) {
      if (j == corner || k == corner) {
        continue;
      }
      const Sides sides = sides_of(points, {corner, j, k});
      if (sides.above != sides.below) {  // both false if the three points share a line or all points share a plane
        return sides.below ? Triangle{corner, j, k} : Triangle{corner, k, j};
      }
    }
  }
  return std::nullopt;
}

/// The corners of the face in the plane of a triangle, in the triangle's orientation, by A. Andrew's monotone chain
/// ("Another efficient algorithm for convex hulls in two dimensions", Inf. Process. Lett. 9, 1979). The chain needs an
/// order along a direction in the plane; the order of coordinates suffices.
Polygon face_through(const Points& points, const Polygon& order, const Triangle& t) {
  const Vector3<int> signs = normal_signs(points[t[0]], points[t[1]], points[t[2]]);
  int axis = 0;  // the axis along which the plane is projected
  while (signs[axis] == 0) {
    ++axis;
  }
  const auto turns_left = [&](std::size_t a, std::size_t b, std::size_t c) {
    return normal_signs(points[a], points[b], points[c])[axis] == signs[axis];
  };
  Polygon in_plane;
  for (const std::size_t i : order) {
    if (side_of_plane(points[t[0]], points[t[1]], points[t[2]], points[i]) == 0) {
      in_plane.push_back(i);
    }
  }
  Polygon corners;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t start = corners.size();
    for (auto i = begin; i != end; ++i) {
      while (corners.size() >= start + 2 && !turns_left(corners[corners.size() - 2], corners.back(), *i)) {
        corners.pop_back();
      }
      corners.push_back(*i);
    }
    corners.pop_back();  // the last point is the first point of the other chain
  };
  add_chain(in_plane.begin(), in_plane.end());
  add_chain(in_plane.rbegin(), in_plane.rend());
  return corners;
}

/// A triangle of the face on the other side of the edge from a to b. The triangle (a, b, inside) is part of a face on
/// this side.
Triangle across(const Points& points, std::size_t a, std::size_t b, std::size_t inside) {
  std::optional<std::size_t> outermost;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (outermost ? side_of_plane(points[b], points[a], points[*outermost], points[i]) > 0
                  : side_of_plane(points[a], points[b], points[inside], points[i]) != 0) {
      outermost = i;
    }
  }
  return {b, a, *outermost};
}

std::optional<ShapeDefect> defect_of_list(const Points& points, const Polygon& order) {
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (points[order[i - 1]] == points[order[i]]) {
      return ShapeDefect{"vertex " + std::to_string(order[i]) + " equals vertex " + std::to_string(order[i - 1]) +
                         "; remove one of them"};
    }
  }
  return std::nullopt;
}

}  // namespace

std::variant<ConvexPolyhedron, ShapeDefect> convex_polyhedron(std::vector<Vector3<double>> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!vertices[i].allFinite()) {
      return ShapeDefect{"vertex " + std::to_string(i) + " has a coordinate that is not a finite number"};
    }
  }
  if (vertices.size() < 4) {
    return ShapeDefect{"a polyhedron needs at least 4 vertices, not " + std::to_string(vertices.size())};
  }
  const Polygon order = in_order(vertices);
  if (const std::optional<ShapeDefect> defect = defect_of_list(vertices, order)) {
    return *defect;
  }
  const std::optional<Triangle> first = first_triangle(vertices, order.front());
  if (!first) {
    return ShapeDefect{"all vertices lie in one plane; a polyhedron needs a volume"};
  }

  ConvexPolyhedron hull;
  std::set<std::pair<std::size_t, std::size_t>> sides;  // of the known faces, each in the orientation of its face
  std::vector<bool> is_corner(vertices.size(), false);
  const auto add_face = [&](const Triangle& triangle) {
    Polygon face = face_through(vertices, order, triangle);
    for (std::size_t i = 0; i < face.size(); ++i) {
      sides.emplace(face[i], face[(i + 1) % face.size()]);
      is_corner[face[i]] = true;
    }
    hull.faces.push_back(std::move(face));
  };
  add_face(*first);
  for (std::size_t known = 0; known < hull.faces.size(); ++known) {
    const Polygon face = hull.faces[known];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::size_t a = face[i];
      const std::size_t b = face[(i + 1) % face.size()];
      if (!sides.contains({b, a})) {
        add_face(across(vertices, a, b, face[(i + 2) % face.size()]));
      }
    }
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!is_corner[i]) {
      return ShapeDefect{
          "vertex " + std::to_string(i) +
          " is not a corner: it lies inside the convex hull of the others, or on its boundary; remove this vertex"};
    }
  }
  for (const auto& [a, b] : sides) {
    if (a < b) {
      hull.edges.push_back({a, b});
    }
  }
  hull.vertices = std::move(vertices);
  return hull;
}

ConvexShape ball_shape(double radius) {
  CAROM_EXPECTS(radius > 0, radius);
  return {{{Vector3<double>::Zero()}, {}, {}}, radius, 0};
}

std::vector<Vector3<double>> placed_vertices(const ConvexShape& shape, const Placement& placement,
                                             const Vector3<double>& origin) {
  const Matrix3<double> rotation = impulse::rotation_matrix(placement.orientation);
  const Vector3<double> offset = placement.position - origin;
  std::vector<Vector3<double>> placed;
  placed.reserve(shape.core.vertices.size());
  for (const Vector3<double>& vertex : shape.core.vertices) {
    placed.emplace_back(offset + rotation * vertex);
  }
  return placed;
}

double placement_error(const ConvexShape& shape, const Placement& placement) {
  return placement.position_error + placement.angle_error * shape.core_radius;
}

}  // namespace carom::scene
