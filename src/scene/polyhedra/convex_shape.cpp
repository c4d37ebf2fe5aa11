// SPDX-License-Identifier: BSL-1.0
#include <carom/collision/expects.hpp>
#include <carom/impulse/rotation.hpp>
#include <carom/scene/polyhedra/convex_shape.hpp>

namespace carom::scene {

ConvexShape convex_shape(const PolyhedralBody& body) { return {body.shape, 0, body.radius}; }

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
