// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <carom/collision/model.hpp>
#include <carom/collision/precision.hpp>
#include <carom/collision/vector.hpp>

namespace carom::scene {

/// How two materials meet.
struct MaterialPair {
  double restitution = 1;             // ε in [0, 1]
  double friction = 0;                // μ ≥ 0, at impacts and where a sphere slides on a plane
  double tangential_restitution = 0;  // e_t in [-1, 1]; read by the law `rough`
  double rolling_resistance = 0;      // μ_r ≥ 0: a sphere that rolls on a plane loses μ_r g of its speed a second
  double spinning_resistance = 0;     // μ_s ≥ 0: its spin about the plane's normal loses (5/2) μ_s g/R a second
};

/// The pairs of `count` materials, in whichever order they meet.
class MaterialPairs {
 public:
  explicit MaterialPairs(std::size_t count = 0) : count_(count), pairs_(count * count) {}
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const MaterialPair& of(std::size_t a, std::size_t b) const { return pairs_[a * count_ + b]; }
  void set(std::size_t a, std::size_t b, const MaterialPair& pair) {
    pairs_[a * count_ + b] = pair;
    pairs_[b * count_ + a] = pair;
  }

 private:
  std::size_t count_;
  std::vector<MaterialPair> pairs_;
};

/// A uniform solid ball, at the scene's beginning. World coordinates.
struct Sphere {
  std::string name;
  double radius = 1;                          // > 0 [m]
  double density = 1;                         // > 0 [kg/m³]
  std::size_t material = 0;                   // index into Scene::materials
  Vector3<double> position{0, 0, 0};          // centre [m]
  Vector3<double> velocity{0, 0, 0};          // [m/s]
  Vector3<double> angular_velocity{0, 0, 0};  // [rad/s]
};

/// A convex body of uniform density, at the scene's beginning. A point x of its own frame is at position + R x, R the
/// rotation of `orientation`. World coordinates but for the vertices.
struct Polyhedron {
  std::string name;
  std::vector<Vector3<double>> vertices;       // its corners, in its own frame [m]
  double density = 1;                          // > 0 [kg/m³]
  std::size_t material = 0;                    // index into Scene::materials
  Vector3<double> position{0, 0, 0};           // of the origin of its own frame [m]
  Quaternion<double> orientation{1, 0, 0, 0};  // own axes to world axes, any nonzero length
  Vector3<double> velocity{0, 0, 0};           // of the centre of mass [m/s]
  Vector3<double> angular_velocity{0, 0, 0};   // [rad/s]
};

/// A fixed half-space: bodies stay on the side that the normal points to.
struct Plane {
  std::string name;
  std::size_t material = 0;         // index into Scene::materials
  Vector3<double> normal{0, 0, 1};  // any nonzero length
  Vector3<double> point{0, 0, 0};   // one of the plane's [m]
};

/// Rebounds from a level plane that rise no higher than this part h of the sphere's radius are not followed: the sphere
/// stays on the plane, as ε = 0 would have it. Where nothing can rest, on another sphere or on a slope, what approaches
/// slower than √(2 g h R) is met elastically and leaves at that speed: it hops on, no higher than that.
inline constexpr double default_capture_height = 1e-6;

struct Scene {
  std::string title;
  Model law = Model::frictionless;            // not `any`
  Precision precision = Precision::binary64;  // that impulses are computed in; the state is kept in binary64
  double duration = 1;                        // ≥ 0 [s]
  Vector3<double> gravity{0, 0, 0};           // [m/s²]; along an axis of the world, or none
  double capture_height = default_capture_height;
  std::vector<std::string> materials;
  MaterialPairs pairs;
  std::vector<Sphere> spheres;
  std::vector<Polyhedron> polyhedra;
  std::vector<Plane> planes;
};

/// Bodies are counted spheres first.
[[nodiscard]] inline std::size_t body_count(const Scene& scene) {
  return scene.spheres.size() + scene.polyhedra.size();
}
[[nodiscard]] inline bool is_sphere(const Scene& scene, std::size_t body) { return body < scene.spheres.size(); }
[[nodiscard]] inline const Polyhedron& polyhedron_of(const Scene& scene, std::size_t body) {
  return scene.polyhedra[body - scene.spheres.size()];
}
[[nodiscard]] inline std::size_t material_of(const Scene& scene, std::size_t body) {
  return is_sphere(scene, body) ? scene.spheres[body].material : polyhedron_of(scene, body).material;
}
/// "sphere 3", "polyhedron 0", as they are counted in the scene.
[[nodiscard]] inline std::string kind_and_number(const Scene& scene, std::size_t body) {
  return is_sphere(scene, body) ? "sphere " + std::to_string(body)
                                : "polyhedron " + std::to_string(body - scene.spheres.size());
}
/// The same with its name: "sphere 3 (cue)".
[[nodiscard]] inline std::string description_of(const Scene& scene, std::size_t body) {
  const std::string& name = is_sphere(scene, body) ? scene.spheres[body].name : polyhedron_of(scene, body).name;
  return kind_and_number(scene, body) + " (" + name + ')';
}

}  // namespace carom::scene
