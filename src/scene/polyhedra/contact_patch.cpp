// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/scene/polyhedra/contact_patch.hpp>
#include <carom/scene/polyhedra/polygon_in_plane.hpp>

namespace carom::scene {
namespace {

using Vector = Vector3<double>;

/// A plane perpendicular to a normal. x, y and the normal are right-handed axes.
struct Plane {
  Vector normal;
  Vector x;
  Vector y;
};

Plane plane_across(const Vector& normal) {
  const Vector x = normal.unitOrthogonal();
  return {normal, x, normal.cross(x)};
}

struct Front {
  double height;         // of the surface, along the normal [m]
  PlanePolygon polygon;  // of the core, projected onto the plane
};

/// The points of a shape that are lowest along the normal (sign −1, for A) or highest (sign +1, for B).
Front front_of(const ConvexShape& shape, const std::vector<Vector>& vertices, const Plane& plane, int sign,
               double flatness) {
  double foremost = -std::numeric_limits<double>::infinity();
  for (const Vector& vertex : vertices) {
    foremost = std::max(foremost, sign * plane.normal.dot(vertex));
  }
  std::vector<PlanePoint> points;
  for (const Vector& vertex : vertices) {
    if (sign * plane.normal.dot(vertex) >= foremost - flatness) {
      points.emplace_back(plane.x.dot(vertex), plane.y.dot(vertex));
    }
  }
  return {sign * (foremost + shape.margin), hull_in_plane(std::move(points), flatness)};
}

/// 0 for a vertex, 1 for an edge, 2 for a face.
std::size_t dimension(const PlanePolygon& polygon) { return std::min<std::size_t>(polygon.size(), 3) - 1; }

ContactKind kind_of(std::size_t one, std::size_t other) {
  constexpr std::array<std::array<ContactKind, 3>, 3> kinds{
      {{ContactKind::vertex_vertex, ContactKind::vertex_edge, ContactKind::vertex_face},
       {ContactKind::vertex_edge, ContactKind::edge_edge, ContactKind::edge_face},
       {ContactKind::vertex_face, ContactKind::edge_face, ContactKind::face_face}}};
  return kinds.at(one).at(other);
}

PlanePolygon common_of(const PlanePolygon& a, const PlanePolygon& b, double flatness) {
  const std::size_t of_a = dimension(a);
  const std::size_t of_b = dimension(b);
  if (of_a == 0 || of_b == 0) {
    return of_a == 0 ? a : b;
  }
  if (of_a == 1 && of_b == 1) {
    return common_of_segments(a, b, flatness);
  }
  PlanePolygon common = of_b == 2 ? clipped(a, b, flatness) : clipped(b, a, flatness);
  // `common` is empty only if the shapes are farther apart than the separation says.
  return common.empty() ? PlanePolygon{centroid(of_b == 2 ? a : b)} : common;
}

ContactPatch patch_of(ContactKind kind, const PlanePolygon& polygon, const Plane& plane, double height,
                      const Vector& origin) {
  const auto lifted = [&](const PlanePoint& point) -> Vector {
    return origin + point.x() * plane.x + point.y() * plane.y + height * plane.normal;
  };
  ContactPatch patch{kind, lifted(centroid(polygon)), {}};
  for (const PlanePoint& point : polygon) {
    patch.vertices.push_back(lifted(point));
  }
  return patch;
}

}  // namespace

std::string_view name_of(ContactKind kind) {
  switch (kind) {
    case ContactKind::vertex_vertex:
      return "vertex-vertex";
    case ContactKind::vertex_edge:
      return "vertex-edge";
    case ContactKind::vertex_face:
      return "vertex-face";
    case ContactKind::edge_edge:
      return "edge-edge";
    case ContactKind::edge_face:
      return "edge-face";
    case ContactKind::face_face:
      return "face-face";
  }
  return "";
}

ContactPatch contact_patch(const ShapePair& pair, const Placement& a, const Placement& b, const Separation& separation,
                           double flatness) {
  CAROM_EXPECTS(flatness > 0, flatness);
  const Plane plane = plane_across(separation.normal);
  const Front front_a = front_of(pair.a(), placed_vertices(pair.a(), a, b.position), plane, -1, flatness);
  const Front front_b = front_of(pair.b(), placed_vertices(pair.b(), b, b.position), plane, 1, flatness);
  const ContactKind kind = kind_of(dimension(front_a.polygon), dimension(front_b.polygon));
  return patch_of(kind, common_of(front_a.polygon, front_b.polygon, flatness), plane,
                  (front_a.height + front_b.height) / 2, b.position);
}

ContactPatch contact_patch(const ConvexShape& a, const Placement& placement, const HalfSpace& b, double flatness) {
  CAROM_EXPECTS(flatness > 0, flatness);
  const Plane plane = plane_across(b.normal);
  const Front front = front_of(a, placed_vertices(a, placement, placement.position), plane, -1, flatness);
  // Heights are relative to the shape's centre.
  const double ground = b.offset - b.normal.dot(placement.position);
  return patch_of(kind_of(dimension(front.polygon), 2), front.polygon, plane, (front.height + ground) / 2,
                  placement.position);
}

}  // namespace carom::scene
