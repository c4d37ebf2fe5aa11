// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>
#include <vector>

#include <carom/scene/polyhedra/distance.hpp>

namespace carom::scene {

/// The features of two shapes that touch, the feature of lower dimension first. A ball touches as a vertex, a
/// half-space as a face.
enum class ContactKind { vertex_vertex, vertex_edge, vertex_face, edge_edge, edge_face, face_face };

[[nodiscard]] std::string_view name_of(ContactKind kind);

/// The places at which two shapes touch or almost touch. All points lie midway between the shapes.
struct ContactPatch {
  ContactKind kind = ContactKind::vertex_vertex;
  /// The point that represents the patch [m, world]: the centroid of a polygon's area, or the middle of a segment.
  Vector3<double> point{0, 0, 0};
  /// The corners of the patch [m, world]: one point, the two ends of a segment, or the corners of a polygon in order.
  /// Their order is counterclockwise as seen from A.
  std::vector<Vector3<double>> vertices;
};

/// The patch between two shapes that are separated along separation.normal. The foremost vertex of a shape is nearest
/// to the other shape along the normal. The vertices within `flatness` [m] of its height form a corner, an edge or a
/// face. The patch is the overlap of the projections of these features along the normal. A vertex or a crossing of two
/// edges gives one point. An edge along an edge or over a face gives a segment, and two faces give a polygon. The patch
/// extends at most `flatness` beyond each side of a feature, and so farther beyond a sharp corner. Two edges count as
/// parallel if they diverge by at most `flatness` over the length of the shorter one. Precondition: the flatness is
/// positive, and small compared with the sides of the faces.
[[nodiscard]] ContactPatch contact_patch(const ShapePair& pair, const Placement& a, const Placement& b,
                                         const Separation& separation, double flatness);
[[nodiscard]] ContactPatch contact_patch(const ConvexShape& a, const Placement& placement, const HalfSpace& b,
                                         double flatness);

}  // namespace carom::scene
