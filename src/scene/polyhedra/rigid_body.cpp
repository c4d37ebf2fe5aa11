// SPDX-License-Identifier: BSL-1.0
#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/scene/polyhedra/rigid_body.hpp>

namespace carom::scene {
namespace {

Eigen::Quaterniond unit(const Quaternion<double>& q) {
  const Quaternion<double> scaled = q / q.cwiseAbs().maxCoeff();
  const Quaternion<double> u = scaled / scaled.norm();
  return {u[0], u[1], u[2], u[3]};
}

}  // namespace

std::variant<RigidBody, ShapeDefect> rigid_body(const Polyhedron& polyhedron) {
  CAROM_EXPECTS(
      polyhedron.position.allFinite() && polyhedron.velocity.allFinite() && polyhedron.angular_velocity.allFinite(),
      polyhedron.position, polyhedron.velocity, polyhedron.angular_velocity);
  CAROM_EXPECTS(polyhedron.orientation.allFinite() && !polyhedron.orientation.isZero(0), polyhedron.orientation);
  const auto hull = convex_polyhedron(polyhedron.vertices);
  if (const auto* defect = std::get_if<ShapeDefect>(&hull)) {
    return *defect;
  }
  const auto moved = polyhedral_body(std::get<ConvexPolyhedron>(hull), polyhedron.density);
  if (const auto* defect = std::get_if<ShapeDefect>(&moved)) {
    return *defect;
  }
  const auto& body = std::get<PolyhedralBody>(moved);
  const Eigen::Quaterniond own = unit(polyhedron.orientation);
  const Eigen::Quaterniond axes = (own * unit(body.properties.orientation)).normalized();
  RigidBody result;
  result.shape = convex_shape(body);
  result.mass = body.properties.mass;
  result.principal_inertia = body.properties.principal_inertia;
  result.position = polyhedron.position + own * body.properties.centre;
  result.orientation = {axes.w(), axes.x(), axes.y(), axes.z()};
  result.velocity = polyhedron.velocity;
  result.angular_velocity = polyhedron.angular_velocity;
  return result;
}

RigidBody rigid_body(const Sphere& sphere) {
  RigidBody result;
  result.shape = ball_shape(sphere.radius);
  const auto properties = sphere_mass_properties(sphere.radius, sphere.density);
  if (const auto* known = std::get_if<MassProperties>(&properties)) {
    result.mass = known->mass;
    result.principal_inertia = known->principal_inertia;
  }
  result.position = sphere.position;
  result.velocity = sphere.velocity;
  result.angular_velocity = sphere.angular_velocity;
  return result;
}

}  // namespace carom::scene
