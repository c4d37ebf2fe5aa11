// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <Eigen/Core>

/// Points, segments and convex polygons in a plane, as their corners: one, two, or more in counterclockwise order.
namespace carom::scene {

using PlanePoint = Eigen::Vector2d;
using PlanePolygon = std::vector<PlanePoint>;

/// The hull of points, by A. Andrew's monotone chain; what is narrower than `slack` is a segment, what is shorter a
/// point.
[[nodiscard]] PlanePolygon hull_in_plane(std::vector<PlanePoint> points, double slack);

/// What of a polygon lies within `slack` of another one with at least three corners (I. Sutherland, G. Hodgman,
/// "Reentrant polygon clipping", Commun. ACM 17, 1974); corners nearer to each other than `slack` are one.
[[nodiscard]] PlanePolygon clipped(PlanePolygon polygon, const PlanePolygon& by, double slack);

/// The same where two segments overlap or cross: the shared segment where they are parallel within `slack`, else one
/// point.
[[nodiscard]] PlanePolygon common_of_segments(const PlanePolygon& first, const PlanePolygon& second, double slack);

/// Of the area, the length or the point. Precondition: not empty.
[[nodiscard]] PlanePoint centroid(const PlanePolygon& polygon);

}  // namespace carom::scene
