// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/scene/polyhedra/polygon_in_plane.hpp>

namespace carom::scene {
namespace {

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

}  // namespace

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

PlanePolygon clipped(PlanePolygon polygon, const PlanePolygon& by, double slack) {
  for (std::size_t i = 0; i < by.size(); ++i) {
    const PlanePoint side = by[(i + 1) % by.size()] - by[i];
    polygon = left_part(polygon, by[i], side.normalized(), slack);
  }
  return without_near_ones(polygon, slack);
}

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

}  // namespace carom::scene
