// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>
#include <vector>

#include <carom/scene/polyhedra/distance.hpp>

namespace carom::scene {

/// What of two shapes touches, the lesser first. A ball touches as a vertex does, a half-space as a face.
enum class ContactKind { vertex_vertex, vertex_edge, vertex_face, edge_edge, edge_face, face_face };

[[nodiscard]] std::string_view name_of(ContactKind kind);

/// Where two shapes that almost touch do so. All points lie midway between the shapes.
struct ContactPatch {
  ContactKind kind = ContactKind::vertex_vertex;
  /// The one point that stands for all [m, world]: of a polygon the centroid of its area, of a segment its middle.
  Vector3<double> point{0, 0, 0};
  /// The corners of the patch [m, world]: one point, two ends of a segment, or a polygon in order, counterclockwise as
  /// seen from A.
  std::vector<Vector3<double>> vertices;
};

/// The patch between two shapes that are separated along separation.normal: the vertices of each that lie within
/// `flatness` [m] of its foremost one make a corner, an edge or a face, and the patch is where their projections along
/// the normal overlap. A vertex, or a crossing of two edges, makes one point, an edge along an edge or over a face a
/// segment, faces a polygon, at most `flatness` beyond the sides of either (so farther at a sharp corner). Two edges
/// count as parallel where they part by no more than `flatness` over the shorter one. Precondition: the flatness is
/// positive, and small beside the sides of the faces.
[[nodiscard]] ContactPatch contact_patch(const ShapePair& pair, const Placement& a, const Placement& b,
                                         const Separation& separation, double flatness);
[[nodiscard]] ContactPatch contact_patch(const ConvexShape& a, const Placement& placement, const HalfSpace& b,
                                         double flatness);

}  // namespace carom::scene
