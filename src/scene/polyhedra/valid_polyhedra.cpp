// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <carom/scene/polyhedra/distance.hpp>
#include <carom/scene/polyhedra/rigid_body.hpp>
#include <carom/scene/polyhedra/valid_polyhedra.hpp>
#include <carom/scene/scene.hpp>
#include <carom/scene/valid_scene.hpp>

namespace carom::scene {
namespace {

using Of = SceneDefect::Of;
using Found = std::optional<SceneDefect>;

/// The greatest distance of a centre of mass from the origin, in radii of the body. At this distance, the rounding
/// error of a position (free_flight.cpp: 2⁻⁴⁹ of all terms) is a hundredth of `contact_tolerance` (free_flight.hpp).
constexpr double farthest = 0x1p12;

/// The greatest angle by which a body may turn within the duration [rad].
constexpr double most_turn = 1e6;

Found number_defect(const Scene& scene, std::size_t i) {
  const Polyhedron& polyhedron = scene.polyhedra[i];
  const auto defect = [&](const char* field, std::string what) {
    return SceneDefect{Of::polyhedron, i, 0, field, std::move(what)};
  };
  if (!(polyhedron.density > 0 && std::isfinite(polyhedron.density))) {
    return defect("density", "expected a number greater than 0");
  }
  if (polyhedron.material >= scene.materials.size()) {
    return defect("material", "expected an index of a material");
  }
  for (const auto& [field, value] :
       {std::pair("position", &polyhedron.position), std::pair("velocity", &polyhedron.velocity),
        std::pair("angular_velocity", &polyhedron.angular_velocity)}) {
    if (!value->allFinite()) {
      return defect(field, "expected finite numbers");
    }
  }
  // Up to this limit, a corner moves by less than the contact tolerance in one ulp of the time.
  if (!(polyhedron.angular_velocity.stableNorm() * scene.duration <= most_turn)) {
    return defect("angular_velocity",
                  text_of("expected a body that rotates by at most ", most_turn, " rad within the duration"));
  }
  if (!polyhedron.orientation.allFinite() || polyhedron.orientation.isZero(0)) {
    return defect("orientation", "expected four finite numbers w, x, y, z that are not all 0");
  }
  return std::nullopt;
}

Found body_defect(const Scene& scene, std::size_t i, std::vector<RigidBody>& bodies) {
  auto body = rigid_body(scene.polyhedra[i]);
  if (const auto* defect = std::get_if<ShapeDefect>(&body)) {
    return SceneDefect{Of::polyhedron, i, 0, "vertices", defect->text};
  }
  bodies.push_back(std::get<RigidBody>(std::move(body)));
  const RigidBody& made = bodies.back();
  const KnownRange range = known_range(scene.precision);
  for (const double value :
       {made.mass, made.principal_inertia[0], made.principal_inertia[1], made.principal_inertia[2]}) {
    if (!range.contains(value)) {
      return SceneDefect{Of::polyhedron, i, 0, "",
                         text_of("expected vertices and density that give mass and moments of inertia from ",
                                 range.least, " to ", range.greatest, ", not ", value)};
    }
  }
  if (!is_moderate(scene, made.mass, made.velocity.stableNorm())) {
    return SceneDefect{Of::polyhedron, i, 0, "velocity", of_moderate_motion};
  }
  if (!is_moderate(scene, made.mass, made.angular_velocity.stableNorm() * made.radius())) {
    return SceneDefect{Of::polyhedron, i, 0, "angular_velocity", of_moderate_motion};
  }
  if (!(made.position.stableNorm() <= farthest * made.radius())) {
    return SceneDefect{Of::polyhedron, i, 0, "",
                       text_of("expected a centre of mass within 4096 radii of the origin, found the distance ",
                               made.position.norm(), " and the radius ", made.radius())};
  }
  return std::nullopt;
}

Placement placement_of(const RigidBody& body) {
  return {body.orientation, body.position, 4 * unit_roundoff(Precision::binary64), 0};
}

/// A plane, or a body with a lower index, from which a body is not certain to be apart.
struct Touch {
  std::string other;
  Separation separation;
};

std::optional<Touch> first_touch(const Scene& scene, const std::vector<RigidBody>& bodies, std::size_t i) {
  const Placement placement = placement_of(bodies[i]);
  for (std::size_t k = 0; k < scene.planes.size(); ++k) {
    const Plane& plane = scene.planes[k];
    const double length = plane.normal.norm();
    const Separation apart = separation(bodies[i].shape, placement,
                                        HalfSpace{plane.normal / length, plane.normal.dot(plane.point) / length});
    if (!(apart.certified > 0)) {
      return Touch{"plane " + std::to_string(k) + " (" + plane.name + ")", apart};
    }
  }
  for (std::size_t k = 0; k < i; ++k) {
    const double radii = bodies[i].radius() + bodies[k].radius();
    if ((bodies[i].position - bodies[k].position).norm() > radii * (1 + 0x1p-40)) {
      continue;
    }
    const ShapePair pair(bodies[i].shape, bodies[k].shape);
    const Separation apart = pair.separation(placement, placement_of(bodies[k]));
    if (!(apart.certified > 0)) {
      return Touch{description_of(scene, k), apart};
    }
  }
  return std::nullopt;
}

Found contact_defect(const Scene& scene, const std::vector<RigidBody>& bodies, std::size_t i) {
  const std::optional<Touch> touch = first_touch(scene, bodies, i);
  if (!touch) {
    return std::nullopt;
  }
  const Separation& apart = touch->separation;
  const bool is_ball = is_sphere(scene, i);
  return SceneDefect{is_ball ? Of::sphere : Of::polyhedron, is_ball ? i : i - scene.spheres.size(), 0, "",
                     text_of(description_of(scene, i), " may overlap ", touch->other, ": ", apart.gap,
                             " m is the computed gap, with a rounding error of up to ", apart.gap - apart.certified,
                             " m; move one of them")};
}

}  // namespace

std::optional<SceneDefect> first_polyhedron_defect(const Scene& scene) {
  if (scene.polyhedra.empty()) {
    return std::nullopt;
  }
  std::vector<RigidBody> bodies;
  for (const Sphere& sphere : scene.spheres) {
    bodies.push_back(rigid_body(sphere));
  }
  for (std::size_t i = 0; i < scene.polyhedra.size(); ++i) {
    if (Found found = number_defect(scene, i)) {
      return found;
    }
    if (Found found = body_defect(scene, i, bodies)) {
      return found;
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (Found found = contact_defect(scene, bodies, i)) {
      return found;
    }
  }
  return std::nullopt;
}

void move_bodies_apart(Scene& scene) {
  constexpr int most_moves = 32;
  std::vector<RigidBody> bodies;
  for (std::size_t i = 0; i < body_count(scene); ++i) {
    const bool is_ball = is_sphere(scene, i);
    if (!is_ball && number_defect(scene, i - scene.spheres.size())) {
      return;  // first_polyhedron_defect names the defect
    }
    Vector3<double>& position =
        is_ball ? scene.spheres[i].position : scene.polyhedra[i - scene.spheres.size()].position;
    const auto body = [&]() -> std::optional<RigidBody> {
      if (is_ball) {
        return rigid_body(scene.spheres[i]);
      }
      auto made = rigid_body(polyhedron_of(scene, i));
      return std::holds_alternative<RigidBody>(made) ? std::optional(std::get<RigidBody>(std::move(made)))
                                                     : std::nullopt;
    };
    std::optional<RigidBody> placed = body();
    if (!placed) {
      return;
    }
    bodies.push_back(*placed);
    const Vector3<double> given = position;
    const double moved_before = scene.moved_apart.farthest;
    for (int tries = 0; tries < most_moves; ++tries) {
      const std::optional<Touch> touch = first_touch(scene, bodies, i);
      const double error = touch ? touch->separation.gap - touch->separation.certified : 0;
      // A body that was moved before may be nearer by its way.
      if (!touch || !(std::abs(touch->separation.gap) <= 2 * error + moved_before)) {
        break;
      }
      position += (2 * error - touch->separation.gap) * touch->separation.normal;
      bodies.back() = *body();
    }
    if (position != given) {
      scene.moved_apart.add((position - given).norm());
    }
  }
}

}  // namespace carom::scene
