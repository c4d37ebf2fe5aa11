// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include <carom/collision/law.hpp>
#include <carom/collision/precision.hpp>
#include <carom/collision/vector.hpp>

namespace carom::scene {

/// The properties of the contact of two materials. p is the part of gravity that presses a sphere onto a plane [m/s²].
struct MaterialPair {
  double restitution = 1;             // ε in [0, 1]
  double friction = 0;                // μ ≥ 0, for impacts and for a sphere that slides on a plane
  double tangential_restitution = 0;  // e_t in [-1, 1]; only the law `rough` reads it
  double rolling_resistance = 0;      // μ_r ≥ 0: slows a sphere that rolls on a plane by μ_r p [m/s²]
  double spinning_resistance = 0;     // μ_s ≥ 0: slows the spin about a plane's normal by (5/2) μ_s p/R [rad/s²]
};

/// The properties of every pair of `count` materials, in either order.
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

/// A uniform solid ball at the beginning of a scene, in world coordinates.
struct Sphere {
  std::string name;
  double radius = 1;                          // > 0 [m]
  double density = 1;                         // > 0 [kg/m³]
  std::size_t material = 0;                   // index into Scene::materials
  Vector3<double> position{0, 0, 0};          // centre [m]
  Vector3<double> velocity{0, 0, 0};          // [m/s]
  Vector3<double> angular_velocity{0, 0, 0};  // [rad/s]
};

/// A convex body of uniform density at the beginning of a scene, in world coordinates except for the vertices. A point
/// x of its own frame is at position + R x, with R the rotation of `orientation`.
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
  Vector3<double> point{0, 0, 0};   // a point of the plane [m]
};

/// The default of the capture height h. A sphere of radius R that would rise at most h R after its impact on a plane
/// stays on the plane, if gravity presses it onto the plane. On another body, an approach slower than √(2 g h R)
/// becomes an elastic impact (ε = 1), after which the bodies part at least at √(2 g f h R) (see `least_speed`).
inline constexpr double default_capture_height = 1e-6;

/// Bodies that touch can overlap by the rounding of their coordinates.
struct MovedApart {
  std::size_t bodies = 0;  // that were moved until they do not overlap
  double farthest = 0;     // [m]

  void add(double distance) {
    ++bodies;
    farthest = std::max(farthest, distance);
  }
};

struct Scene {
  std::string title;
  Law law = Law::frictionless;                // not `any`
  Precision precision = Precision::binary64;  // of the impulses; the state is stored in binary64
  double duration = 1;                        // ≥ 0 [s]
  Vector3<double> gravity{0, 0, 0};           // [m/s²]
  double capture_height = default_capture_height;
  std::vector<std::string> materials;
  MaterialPairs pairs;
  std::vector<Sphere> spheres;
  std::vector<Polyhedron> polyhedra;
  std::vector<Plane> planes;
  MovedApart moved_apart;  // since the file was read
};

/// Body indices count the spheres first, then the polyhedra.
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
/// The kind of a body and its number of this kind: "sphere 3", "polyhedron 0".
[[nodiscard]] inline std::string kind_and_number(const Scene& scene, std::size_t body) {
  return is_sphere(scene, body) ? "sphere " + std::to_string(body)
                                : "polyhedron " + std::to_string(body - scene.spheres.size());
}
/// The kind, number and name of a body: "sphere 3 (cue)".
[[nodiscard]] inline std::string description_of(const Scene& scene, std::size_t body) {
  const std::string& name = is_sphere(scene, body) ? scene.spheres[body].name : polyhedron_of(scene, body).name;
  return kind_and_number(scene, body) + " (" + name + ')';
}

/// A capture changes the energy by up to m g h R, with the scene's capture height h in radii R. If ε = 1, the energy
/// must stay constant, so this factor reduces h. A slow contact adds up to f m g h R with this factor f, whatever ε is.
/// With the default h, these changes are at most 10⁻¹² m g R.
inline constexpr double elastic_capture_share = 1e-6;

/// The least speed of a rebound that the simulation follows, √(2 a f h R) [m/s]. The factor f is
/// `elastic_capture_share` if ε = 1, otherwise 1. At this speed a body rises by f h R against the acceleration a.
[[nodiscard]] inline double least_speed(const Scene& scene, double acceleration, double radius, double restitution) {
  const double height = scene.capture_height * radius * (restitution < 1 ? 1 : elastic_capture_share);
  return std::sqrt(2 * acceleration * height);
}

/// Whether a law has tangential impulses. If so, planes have friction, too.
[[nodiscard]] constexpr bool has_friction(Law law) { return law != Law::frictionless && law != Law::reflection; }

/// The parts in one text. Numbers have six digits.
template <class... Parts>
[[nodiscard]] std::string text_of(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

}  // namespace carom::scene
