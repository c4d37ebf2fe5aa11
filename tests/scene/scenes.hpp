// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/sphere_simulation.hpp>
#include <carom/scene/valid_scene.hpp>

namespace carom::unit {

/// A scene without bodies, with one material.
[[nodiscard]] inline scene::Scene empty_scene(Law law, const scene::MaterialPair& pair, double duration) {
  scene::Scene scene;
  scene.law = law;
  scene.duration = duration;
  scene.materials = {"all"};
  scene.pairs = scene::MaterialPairs(1);
  scene.pairs.set(0, 0, pair);
  return scene;
}

inline void add_sphere(scene::Scene& scene, double radius, const Vector3<double>& position,
                       const Vector3<double>& velocity) {
  scene::Sphere sphere;
  sphere.name = "ball " + std::to_string(scene.spheres.size());
  sphere.radius = radius;
  sphere.position = position;
  sphere.velocity = velocity;
  scene.spheres.push_back(sphere);
}

inline void add_plane(scene::Scene& scene, const Vector3<double>& normal, const Vector3<double>& point) {
  scene.planes.push_back({"plane " + std::to_string(scene.planes.size()), 0, normal, point});
}

/// Adds a polyhedron with the origin of its own frame at the position.
inline void add_polyhedron(scene::Scene& scene, const std::vector<Vector3<double>>& vertices,
                           const Vector3<double>& position, const Vector3<double>& velocity = {0, 0, 0},
                           const Vector3<double>& angular_velocity = {0, 0, 0}) {
  scene::Polyhedron polyhedron;
  polyhedron.name = "body " + std::to_string(scene.polyhedra.size());
  polyhedron.vertices = vertices;
  polyhedron.position = position;
  polyhedron.velocity = velocity;
  polyhedron.angular_velocity = angular_velocity;
  scene.polyhedra.push_back(polyhedron);
}

/// The corners of a box about 0 with edges of these lengths.
[[nodiscard]] inline std::vector<Vector3<double>> centred_box(const Vector3<double>& edges) {
  std::vector<Vector3<double>> corners;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        corners.push_back(edges.cwiseProduct(Vector3<double>(x, y, z)));
      }
    }
  }
  return corners;
}

/// Four corners of the cube from −size to size.
[[nodiscard]] inline std::vector<Vector3<double>> centred_tetrahedron(double size) {
  return {{size, size, size}, {size, -size, -size}, {-size, size, -size}, {-size, -size, size}};
}

/// Six planes around [0, size]³.
inline void add_box(scene::Scene& scene, double size) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3<double> normal = Vector3<double>::Unit(axis);
    add_plane(scene, normal, Vector3<double>::Zero());
    add_plane(scene, -normal, size * normal);
  }
}

/// side³ spheres of mixed radii in a box of side³ unit cells, one in each cell.
[[nodiscard]] inline scene::Scene box_of_spheres(Law law, const scene::MaterialPair& pair, int side, double duration,
                                                 std::uint64_t gas_seed) {
  properties::Stream stream = properties::stream_from(gas_seed);
  scene::Scene scene = empty_scene(law, pair, duration);
  add_box(scene, side);
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) {
        const double radius = stream.between(0.2, 0.4);
        const Vector3<double> cell{x + 0.5, y + 0.5, z + 0.5};
        const Vector3<double> aside = 0.09 * stream.vector();
        const Vector3<double> velocity = 2 * stream.vector();
        add_sphere(scene, radius, cell + aside, velocity);
        scene.spheres.back().angular_velocity = 3 * stream.vector();
        scene.spheres.back().density = stream.between(0.5, 2);
      }
    }
  }
  return scene;
}

/// side³ boxes and tetrahedra, and optionally balls, in a box of side³ unit cells. Each cell has one body, in a random
/// orientation.
[[nodiscard]] inline scene::Scene box_of_bodies(Law law, const scene::MaterialPair& pair, int side, double duration,
                                                std::uint64_t gas_seed, bool has_balls) {
  properties::Stream stream = properties::stream_from(gas_seed);
  scene::Scene scene = empty_scene(law, pair, duration);
  add_box(scene, side);
  for (int cell = 0; cell < side * side * side; ++cell) {
    // Bodies reach 0.4 from their centres, which are within 0.09 of the cells' centres.
    const Vector3<double> aside = 0.09 * stream.vector();
    const Vector3<double> centre =
        Vector3<double>(cell % side + 0.5, cell / side % side + 0.5, cell / (side * side) + 0.5) + aside;
    const Vector3<double> velocity = 2 * stream.vector();
    const Vector3<double> angular_velocity = 3 * stream.vector();
    const double density = stream.between(0.5, 2);
    if (has_balls && cell % 3 == 2) {
      add_sphere(scene, stream.between(0.2, 0.4), centre, velocity);
      scene.spheres.back().angular_velocity = angular_velocity;
      scene.spheres.back().density = density;
      continue;
    }
    const Vector3<double> edges(stream.between(0.1, 0.45), stream.between(0.1, 0.45), stream.between(0.1, 0.45));
    add_polyhedron(scene, cell % 2 == 0 ? centred_box(edges) : centred_tetrahedron(edges.maxCoeff() / 2), centre,
                   velocity, angular_velocity);
    scene.polyhedra.back().orientation = stream.quaternion();
    scene.polyhedra.back().density = density;
  }
  return scene;
}

/// Copies of the first events of a scene, at most `most`, without renewals.
template <class Loop = scene::SphereSimulation>
[[nodiscard]] inline std::vector<scene::Event> events_of(scene::Scene scene, std::size_t most) {
  Loop simulation(std::move(scene));
  std::vector<scene::Event> events;
  while (events.size() < most) {
    const scene::Event* event = simulation.advance();
    if (event == nullptr) {
      break;
    }
    if (event->kind != scene::EventKind::renewal) {
      events.push_back(*event);
    }
  }
  return events;
}

}  // namespace carom::unit
