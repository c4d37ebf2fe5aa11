// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <Eigen/Core>

/// Convex polygons in a plane, stored as their corners: a point, a segment, or more corners in counterclockwise order.
namespace carom::scene {

using PlanePoint = Eigen::Vector2d;
using PlanePolygon = std::vector<PlanePoint>;

/// The hull of points, by A. Andrew's monotone chain. It becomes a segment if its width is at most `slack`, and a point
/// if its length is at most `slack`.
[[nodiscard]] PlanePolygon hull_in_plane(std::vector<PlanePoint> points, double slack);

/// The part of a polygon within `slack` of the polygon `by` (I. Sutherland, G. Hodgman, "Reentrant polygon clipping",
/// Commun. ACM 17, 1974). Corners nearer to each other than `slack` are merged. Precondition: `by` has at least three
/// corners.
[[nodiscard]] PlanePolygon clipped(PlanePolygon polygon, const PlanePolygon& by, double slack);

/// The common part of two segments that overlap or cross: the shared segment if they are parallel within `slack`,
/// otherwise one point.
[[nodiscard]] PlanePolygon common_of_segments(const PlanePolygon& first, const PlanePolygon& second, double slack);

/// The centroid of the polygon, the segment or the point. Precondition: the polygon is not empty.
[[nodiscard]] PlanePoint centroid(const PlanePolygon& polygon);

}  // namespace carom::scene
