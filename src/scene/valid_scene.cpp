// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include <carom/scene/cell_grid.hpp>
#include <carom/scene/placing.hpp>
#include <carom/scene/prediction.hpp>
#include <carom/scene/scene.hpp>
#include <carom/scene/valid_scene.hpp>

namespace carom::scene {
namespace {

using Of = SceneDefect::Of;
using Found = std::optional<SceneDefect>;

/// The greatest coordinate of a position, in diameters of the largest sphere. So an ulp of a coordinate is at most 2⁻²⁴
/// diameters.
constexpr double farthest = 0x1p28;

constexpr double least_gravity = 1e-200;

Found scene_defect(const Scene& scene) {
  const auto defect = [](const char* field, const char* what) { return SceneDefect{Of::scene, 0, 0, field, what}; };
  if (scene.law == Law::any) {
    return defect("law", "expected frictionless, reflection, sticking, rough or coulomb");
  }
  if (!(scene.duration >= 0 && std::isfinite(scene.duration))) {
    return defect("duration", "expected a finite number of at least 0");
  }
  if (!scene.gravity.allFinite()) {
    return defect("gravity", "expected finite numbers");
  }
  if (const double g = scene.gravity.cwiseAbs().maxCoeff(); g > 0 && g < least_gravity) {
    return defect("gravity", "expected 0 or at least 1e-200 m/s^2, so that its effect does not underflow");
  }
  if (!is_moderate(scene, 0, scene.gravity.stableNorm() * std::max(1.0, scene.duration))) {
    return defect("gravity", of_moderate_motion);
  }
  if (!(scene.capture_height > 0 && std::isfinite(scene.capture_height))) {
    return defect("capture_height", "expected a finite number greater than 0");
  }
  if (scene.pairs.count() != scene.materials.size()) {
    return defect("pairs", "expected pairs of as many materials as the scene has");
  }
  return std::nullopt;
}

Found pair_defect(const Scene& scene) {
  for (std::size_t a = 0; a < scene.materials.size(); ++a) {
    for (std::size_t b = a; b < scene.materials.size(); ++b) {
      const MaterialPair& pair = scene.pairs.of(a, b);
      const char* const at_least_0 = "expected a finite number of at least 0";
      constexpr double greatest = std::numeric_limits<double>::max();
      for (const auto& [field, value, least, most, what] :
           {std::tuple("restitution", pair.restitution, 0.0, 1.0, "expected a number from 0 to 1"),
            std::tuple("tangential_restitution", pair.tangential_restitution, -1.0, 1.0,
                       "expected a number from -1 to 1"),
            std::tuple("friction", pair.friction, 0.0, greatest, at_least_0),
            std::tuple("rolling_resistance", pair.rolling_resistance, 0.0, greatest, at_least_0),
            std::tuple("spinning_resistance", pair.spinning_resistance, 0.0, greatest, at_least_0)}) {
        if (!(value >= least && value <= most)) {
          return SceneDefect{Of::pair, a, b, field, what};
        }
      }
    }
  }
  return std::nullopt;
}

Found plane_defect(const Scene& scene) {
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    const Plane& plane = scene.planes[i];
    const auto defect = [&](const char* field, const char* what) { return SceneDefect{Of::plane, i, 0, field, what}; };
    if (plane.material >= scene.materials.size()) {
      return defect("material", "expected an index of a material");
    }
    if (!plane.normal.allFinite()) {
      return defect("normal", "expected finite numbers");
    }
    if (!std::isnormal(plane.normal.squaredNorm())) {
      return defect("normal", "expected a vector with a length that is not 0 and does not overflow binary64");
    }
    if (!plane.point.allFinite()) {
      return defect("point", "expected finite numbers");
    }
  }
  return std::nullopt;
}

Found sphere_defect(const Scene& scene, std::size_t i) {
  const Sphere& sphere = scene.spheres[i];
  const auto defect = [&](const char* field, std::string what) {
    return SceneDefect{Of::sphere, i, 0, field, std::move(what)};
  };
  for (const auto& [field, value] : {std::pair("radius", sphere.radius), std::pair("density", sphere.density)}) {
    if (!(value > 0 && std::isfinite(value))) {
      return defect(field, "expected a number greater than 0");
    }
  }
  if (sphere.material >= scene.materials.size()) {
    return defect("material", "expected an index of a material");
  }
  for (const auto& [field, value] : {std::pair("position", &sphere.position), std::pair("velocity", &sphere.velocity),
                                     std::pair("angular_velocity", &sphere.angular_velocity)}) {
    if (!value->allFinite()) {
      return defect(field, "expected finite numbers");
    }
  }
  // The formulas are those of sphere_store.cpp, so the roundings are equal.
  const double mass = sphere.density * (4.0 / 3.0) * std::numbers::pi * sphere.radius * sphere.radius * sphere.radius;
  const double moment = 0.4 * mass * sphere.radius * sphere.radius;
  const KnownRange range = known_range(scene.precision);
  for (const auto& [name, value] : {std::pair("a mass", mass), std::pair("a moment of inertia", moment)}) {
    if (!range.contains(value)) {
      return defect("", text_of("expected radius and density that give ", name, " from ", range.least, " to ",
                                range.greatest, ", not ", value));
    }
  }
  if (!is_moderate(scene, mass, sphere.velocity.stableNorm())) {
    return defect("velocity", of_moderate_motion);
  }
  if (!is_moderate(scene, mass, sphere.angular_velocity.stableNorm() * sphere.radius)) {
    return defect("angular_velocity", of_moderate_motion);
  }
  return std::nullopt;
}

Found spheres_defect(const Scene& scene) {
  double radius = 0;
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    if (Found found = sphere_defect(scene, i)) {
      return found;
    }
    radius = std::max(radius, scene.spheres[i].radius);
  }
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    if (scene.spheres[i].position.cwiseAbs().maxCoeff() / (2 * radius) > farthest) {
      return SceneDefect{Of::sphere, i, 0, "position",
                         "expected a position within 2^28 diameters of the largest sphere from the origin"};
    }
  }
  return std::nullopt;
}

/// Whether the sphere is above the plane by more than any rounding error.
bool is_far_above(const Sphere& sphere, const Plane& plane) {
  const double height = plane.normal.dot(sphere.position - plane.point) - sphere.radius * plane.normal.norm();
  const double size =
      plane.normal.cwiseAbs().sum() * (sphere.position.cwiseAbs().sum() + plane.point.cwiseAbs().sum() + sphere.radius);
  return height > 0x1p-40 * size;
}

/// The spheres at the beginning, put into a grid one after the other.
class PlacedSpheres {
 public:
  explicit PlacedSpheres(const Scene& scene) : scene_(scene), paths_(scene.spheres.size()) {
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      paths_[i].position = scene.spheres[i].position;
      paths_[i].radius = scene.spheres[i].radius;
      measure(paths_[i]);
    }
    grid_ = grid_around(paths_);
  }

  void put(CellGrid::Index i) { grid_.put(i, paths_[i].position); }
  void move(CellGrid::Index i, const Vector3<double>& position) {
    paths_[i].position = position;
    measure(paths_[i]);
  }

  /// The first plane that a sphere overlaps.
  [[nodiscard]] std::optional<std::size_t> plane_in(CellGrid::Index i) {
    for (std::size_t k = 0; k < scene_.planes.size(); ++k) {
      const Plane& plane = scene_.planes[k];
      Sphere sphere;
      sphere.radius = paths_[i].radius;
      sphere.position = paths_[i].position;
      if (!is_far_above(sphere, plane) &&
          overlap(paths_[i], {plane.normal, reach_of(plane.normal, plane.point, sphere.radius)}, 0, undecided_)) {
        return k;
      }
    }
    return std::nullopt;
  }
  /// A sphere in the grid that a sphere overlaps. Precondition: the sphere is in the grid, too.
  [[nodiscard]] std::optional<std::size_t> sphere_in(CellGrid::Index i) {
    std::optional<std::size_t> partner;
    grid_.for_neighbours(i, [&](CellGrid::Index j) {
      if (!partner && overlap(paths_[i], paths_[j], 0, undecided_)) {
        partner = j;
      }
    });
    return partner;
  }
  [[nodiscard]] const Path& path(std::size_t i) const { return paths_[i]; }

 private:
  const Scene& scene_;
  std::vector<Path> paths_;
  CellGrid grid_;
  unsigned long long undecided_ = 0;
};

Found overlap_defect(const Scene& scene) {
  PlacedSpheres placed(scene);
  for (CellGrid::Index i = 0; i < scene.spheres.size(); ++i) {
    if (const auto plane = placed.plane_in(i)) {
      return SceneDefect{Of::sphere, i, 0, "",
                         text_of(description_of(scene, i), " overlaps plane ", *plane, " (", scene.planes[*plane].name,
                                 "), or is behind it; move one of them")};
    }
    placed.put(i);
    if (const auto partner = placed.sphere_in(i)) {
      return SceneDefect{Of::sphere, i, 0, "",
                         description_of(scene, i) + " overlaps " + description_of(scene, *partner)};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<SceneDefect> first_defect(const Scene& scene) {
  for (const auto& find : {scene_defect, pair_defect, plane_defect, spheres_defect, overlap_defect}) {
    if (Found found = find(scene)) {
      return found;
    }
  }
  return std::nullopt;
}

bool has_valid_fields(const Scene& scene) {
  return !scene_defect(scene) && !pair_defect(scene) && !plane_defect(scene) && !spheres_defect(scene);
}

bool is_moderate(const Scene& scene, double mass, double speed) {
  constexpr double farthest_way = 0x1p100;
  constexpr double greatest_energy = 0x1p1000;
  return speed * std::max(1.0, scene.duration) <= farthest_way && mass * speed * speed <= greatest_energy;
}

void move_apart(Scene& scene) {
  constexpr int most_moves = 32;
  PlacedSpheres placed(scene);
  for (CellGrid::Index i = 0; i < scene.spheres.size(); ++i) {
    placed.put(i);
    const double moved_before = scene.moved_apart.farthest;
    const Path& path = placed.path(i);
    for (int tries = 1; tries <= most_moves; ++tries) {
      Vector3<double> away;
      double depth = 0;
      double size = path.position_size + path.radius;
      if (const auto k = placed.plane_in(i)) {
        const Plane& plane = scene.planes[*k];
        away = plane.normal.normalized();
        depth = path.radius - away.dot(path.position - plane.point);
        size += plane.point.cwiseAbs().sum();
      } else if (const auto j = placed.sphere_in(i)) {
        const Path& other = placed.path(*j);
        away = (path.position - other.position).normalized();
        depth = path.radius + other.radius - (path.position - other.position).norm();
        size += other.position_size + other.radius;
      } else {
        break;
      }
      // A coordinate or a radius that was read is wrong by at most its unit roundoff. The operations add a few more.
      // A sphere that was moved before may be nearer by its way.
      if (!(depth <= 4 * roundoff * size + moved_before)) {
        break;
      }
      placed.move(i, path.position + (std::max(0.0, depth) + tries * roundoff * size) * away);
    }
    if (path.position != scene.spheres[i].position) {
      scene.moved_apart.add((path.position - scene.spheres[i].position).norm());
      scene.spheres[i].position = path.position;
    }
  }
}

std::string describe(const SceneDefect& defect) {
  const std::string field = defect.field.empty() ? "" : '.' + defect.field;
  switch (defect.of) {
    case Of::scene:
      break;
    case Of::pair:
      return text_of("pairs of materials[", defect.index, "] and materials[", defect.other, "]", field, ": ",
                     defect.what);
    case Of::plane:
      return text_of("planes[", defect.index, "]", field, ": ", defect.what);
    case Of::sphere:
      return text_of("spheres[", defect.index, "]", field, ": ", defect.what);
    case Of::polyhedron:
      return text_of("polyhedra[", defect.index, "]", field, ": ", defect.what);
  }
  return defect.field + ": " + defect.what;
}

}  // namespace carom::scene
