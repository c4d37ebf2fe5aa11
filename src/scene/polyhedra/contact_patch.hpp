// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/scene/polyhedra/distance.hpp>

namespace carom::scene {

/// The places at which two shapes touch or almost touch, midway between the shapes.
struct ContactPatch {
  /// The centroid of the patch [m, world].
  Vector3<double> point{0, 0, 0};
  /// The corners of the patch [m, world]: one point, two ends of a segment, or corners of a polygon, counterclockwise
  /// as seen from A.
  std::vector<Vector3<double>> vertices;
};

/// The patch between two shapes that are separated along separation.normal. In each shape, the vertices within
/// `flatness` [m] of the foremost vertex along the normal form the feature that touches: a vertex, an edge or a face.
/// The patch is the overlap of the projections of both features along the normal. It is one point for a vertex or a
/// crossing of edges, a segment for an edge along an edge or over a face, and a polygon for two faces. The patch
/// extends at most `flatness` beyond each side of a feature. Two edges count as parallel if they diverge by at most
/// `flatness` over the length of the shorter edge. Precondition: the flatness is positive, and small compared with the
/// sides of the faces.
[[nodiscard]] ContactPatch contact_patch(const ShapePair& pair, const Placement& a, const Placement& b,
                                         const Separation& separation, double flatness);
[[nodiscard]] ContactPatch contact_patch(const ConvexShape& a, const Placement& placement, const HalfSpace& b,
                                         double flatness);

}  // namespace carom::scene
