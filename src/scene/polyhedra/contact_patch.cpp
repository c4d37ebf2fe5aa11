// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/scene/polyhedra/contact_patch.hpp>

namespace carom::scene {
namespace {

using Vector = Vector3<double>;

/// A convex polygon in a plane, stored as its corners: a point, a segment, or more corners in counterclockwise order.
using PlanePoint = Eigen::Vector2d;
using PlanePolygon = std::vector<PlanePoint>;

double cross(const PlanePoint& x, const PlanePoint& y) { return x.x() * y.y() - x.y() * y.x(); }

PlanePolygon without_near_ones(const PlanePolygon& polygon, double slack) {
  PlanePolygon kept;
  for (const PlanePoint& point : polygon) {
    if (kept.empty() || (point - kept.back()).norm() > slack) {
      kept.push_back(point);
    }
  }
  while (kept.size() > 1 && (kept.back() - kept.front()).norm() <= slack) {
    kept.pop_back();
  }
  return kept;
}

/// The part of a polygon on the left of a line through `start`, including a strip of width `slack` on the right.
/// `direction` has length 1.
PlanePolygon left_part(const PlanePolygon& polygon, const PlanePoint& start, const PlanePoint& direction,
                       double slack) {
  PlanePolygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanePoint& here = polygon[i];
    const PlanePoint& next = polygon[(i + 1) % polygon.size()];
    const double height = cross(direction, here - start) + slack;
    const double next_height = cross(direction, next - start) + slack;
    if (height >= 0) {
      part.push_back(here);
    }
    if ((height < 0) != (next_height < 0)) {
      part.emplace_back(here + height / (height - next_height) * (next - here));
    }
  }
  return part;
}

/// The hull of points, by A. Andrew's monotone chain. It becomes a segment if its width is at most `slack`, and a point
/// if its length is at most `slack`.
PlanePolygon hull_in_plane(std::vector<PlanePoint> points, double slack) {
  std::sort(points.begin(), points.end(), [](const PlanePoint& left, const PlanePoint& right) {
    return std::pair{left.x(), left.y()} < std::pair{right.x(), right.y()};
  });
  PlanePolygon hull;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto point = begin; point != end; ++point) {
      while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], *point - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(*point);
    }
    hull.pop_back();
  };
  if (points.size() > 1) {
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
  } else {
    hull = std::move(points);
  }
  // The longest diagonal, and the greatest distance of a corner from it.
  std::pair<PlanePoint, PlanePoint> ends{hull.front(), hull.front()};
  for (const PlanePoint& x : hull) {
    for (const PlanePoint& y : hull) {
      if ((y - x).squaredNorm() > (ends.second - ends.first).squaredNorm()) {
        ends = {x, y};
      }
    }
  }
  const double length = (ends.second - ends.first).norm();
  if (length <= slack) {
    return {ends.first};
  }
  double width = 0;
  for (const PlanePoint& x : hull) {
    width = std::max(width, std::abs(cross(ends.second - ends.first, x - ends.first)) / length);
  }
  return width <= slack ? PlanePolygon{ends.first, ends.second} : hull;
}

/// The part of a polygon within `slack` of the polygon `by` (I. Sutherland, G. Hodgman, "Reentrant polygon clipping",
/// Commun. ACM 17, 1974). Corners nearer to each other than `slack` are merged. Precondition: `by` has at least three
/// corners.
PlanePolygon clipped(PlanePolygon polygon, const PlanePolygon& by, double slack) {
  for (std::size_t i = 0; i < by.size(); ++i) {
    const PlanePoint side = by[(i + 1) % by.size()] - by[i];
    polygon = left_part(polygon, by[i], side.normalized(), slack);
  }
  return without_near_ones(polygon, slack);
}

/// The common part of two segments that overlap or cross: the shared segment if they are parallel within `slack`,
/// otherwise one point.
PlanePolygon common_of_segments(const PlanePolygon& first, const PlanePolygon& second, double slack) {
  const PlanePoint u = first[1] - first[0];
  const PlanePoint v = second[1] - second[0];
  const PlanePoint to_second = second[0] - first[0];
  const double sine = cross(u.normalized(), v.normalized());
  if (std::abs(sine) * std::min(u.norm(), v.norm()) > slack) {
    const double share = std::clamp(cross(to_second, v) / cross(u, v), 0.0, 1.0);
    return {first[0] + share * u};
  }
  const double one = to_second.dot(u) / u.squaredNorm();
  const double other = (to_second + v).dot(u) / u.squaredNorm();
  const double start = std::clamp(std::min(one, other), 0.0, 1.0);
  const double end = std::clamp(std::max(one, other), 0.0, 1.0);
  return without_near_ones({first[0] + start * u, first[0] + end * u}, slack);
}

/// The centroid of the polygon, the segment or the point. Precondition: the polygon is not empty.
PlanePoint centroid(const PlanePolygon& polygon) {
  CAROM_EXPECTS(!polygon.empty());
  double area = 0;
  PlanePoint moment = PlanePoint::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const PlanePoint x = polygon[i - 1] - polygon[0];
    const PlanePoint y = polygon[i] - polygon[0];
    area += cross(x, y);
    moment += cross(x, y) * (x + y) / 3;
  }
  if (area > 0) {
    return polygon[0] + moment / area;
  }
  PlanePoint sum = PlanePoint::Zero();
  for (const PlanePoint& point : polygon) {
    sum += point;
  }
  return sum / static_cast<double>(polygon.size());
}

/// A plane perpendicular to a normal. x, y and the normal are right-handed axes.
struct FittedPlane {
  Vector normal;
  Vector x;
  Vector y;
};

FittedPlane plane_across(const Vector& normal) {
  const Vector x = normal.unitOrthogonal();
  return {normal, x, normal.cross(x)};
}

struct Front {
  double height;         // of the surface, along the normal [m]
  PlanePolygon polygon;  // of the core, projected onto the plane
};

/// The points of a shape that are lowest along the normal (sign −1, for A) or highest (sign +1, for B).
Front front_of(const ConvexShape& shape, const std::vector<Vector>& vertices, const FittedPlane& plane, int sign,
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

ContactPatch patch_of(const PlanePolygon& polygon, const FittedPlane& plane, double height, const Vector& origin) {
  const auto lifted = [&](const PlanePoint& point) -> Vector {
    return origin + point.x() * plane.x + point.y() * plane.y + height * plane.normal;
  };
  ContactPatch patch{lifted(centroid(polygon)), {}};
  for (const PlanePoint& point : polygon) {
    patch.vertices.push_back(lifted(point));
  }
  return patch;
}

}  // namespace

ContactPatch contact_patch(const ShapePair& pair, const Placement& a, const Placement& b, const Separation& separation,
                           double flatness) {
  CAROM_EXPECTS(flatness > 0, flatness);
  const FittedPlane plane = plane_across(separation.normal);
  const Front front_a = front_of(pair.a(), placed_vertices(pair.a(), a, b.position), plane, -1, flatness);
  const Front front_b = front_of(pair.b(), placed_vertices(pair.b(), b, b.position), plane, 1, flatness);
  return patch_of(common_of(front_a.polygon, front_b.polygon, flatness), plane, (front_a.height + front_b.height) / 2,
                  b.position);
}

ContactPatch contact_patch(const ConvexShape& a, const Placement& placement, const HalfSpace& b, double flatness) {
  CAROM_EXPECTS(flatness > 0, flatness);
  const FittedPlane plane = plane_across(b.normal);
  const Front front = front_of(a, placed_vertices(a, placement, placement.position), plane, -1, flatness);
  // Heights are relative to the shape's centre.
  const double ground = b.offset - b.normal.dot(placement.position);
  return patch_of(front.polygon, plane, (front.height + ground) / 2, placement.position);
}

}  // namespace carom::scene
