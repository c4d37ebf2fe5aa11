// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <carom/collision/expects.hpp>
#include <carom/scene/motion.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// What spheres that are made alike have in common.
struct Make {
  double radius;         // [m]
  double mass;           // [kg]
  double moment;         // (2/5) m R² [kg m²]
  std::size_t material;  // index into Scene::materials
};

/// What is read of a sphere by all whose neighbour it is: one line of a cache. Its acceleration is gravity's, unless it
/// is on a plane, and its radius that of its make.
struct alignas(64) Track {
  Vector3<double> position{0, 0, 0};
  double start = 0;  // of the path [s]
  Vector3<double> velocity{0, 0, 0};
  double until = never;  // the path ends then, or what is further off is not looked for yet: the loop's own [s]
};
static_assert(sizeof(Track) == 64);

/// Bounds of places [m] and velocities [m/s].
struct Extent {
  double position_size, velocity_size;
};

/// The motions of all spheres of a scene. Events are anywhere in space, so that each reads memory that no cache holds
/// any more: what is read together lies together here, and what many spheres share is kept once.
class SphereStore {
 public:
  using Index = std::uint32_t;

  SphereStore() = default;
  /// The spheres as they are at the beginning, flying.
  explicit SphereStore(const Scene& scene);

  [[nodiscard]] std::size_t size() const { return tracks_.size(); }
  [[nodiscard]] const std::vector<Make>& makes() const { return makes_; }
  [[nodiscard]] std::size_t make_index(std::size_t sphere) const { return tags_[sphere] / 2; }
  [[nodiscard]] const Make& make(std::size_t sphere) const { return makes_[make_index(sphere)]; }
  [[nodiscard]] const Track& track(std::size_t sphere) const { return tracks_[sphere]; }
  [[nodiscard]] bool is_flying(std::size_t sphere) const { return tags_[sphere] % 2 == 0; }
  /// Precondition: it is not flying.
  [[nodiscard]] std::uint32_t plane(std::size_t sphere) const {
    CAROM_EXPECTS(!is_flying(sphere), sphere);
    return turnings_[sphere].turning.plane;
  }

  [[nodiscard]] const Vector3<double>& acceleration(std::size_t sphere) const {
    return is_flying(sphere) ? gravity_ : accelerations_[sphere];
  }
  [[nodiscard]] Path path(std::size_t sphere) const {
    const Track& track = tracks_[sphere];
    Path path;
    path.start = track.start;
    path.end = is_flying(sphere) ? never : turnings_[sphere].end;
    path.position = track.position;
    path.velocity = track.velocity;
    path.acceleration = acceleration(sphere);
    path.radius = make(sphere).radius;
    measure(path);
    return path;
  }
  /// What the sizes of all places and velocities from the beginning up to `now` have been at most, in the 1-norm, but
  /// for a few roundings. Accelerations of spheres on planes are left out.
  [[nodiscard]] Extent extent(double now) const {
    const double turn = gravity_size_ * now;
    return {position_size_ + now * (velocity_size_ + turn), velocity_size_ + turn};
  }
  [[nodiscard]] Arc arc(std::size_t sphere) const { return {path(sphere), turnings_[sphere].turning}; }
  /// Precondition: the radius is that of the sphere's make; where it flies, the acceleration is gravity, and no end.
  void set_arc(std::size_t sphere, const Arc& arc);
  void set_position(std::size_t sphere, const Vector3<double>& position);
  void set_until(std::size_t sphere, double until) { tracks_[sphere].until = until; }

  /// Asks for what `track` and the acceleration of a sphere that flies read, before they do.
  void prefetch(std::size_t sphere) const {
    __builtin_prefetch(&tracks_[sphere]);
    __builtin_prefetch(&tags_[sphere]);
  }

  [[nodiscard]] std::size_t bytes_per_sphere() const {
    return sizeof(Track) + sizeof(TurningAndEnd) + sizeof(Tag) + (accelerations_.empty() ? 0 : sizeof(Vector3<double>));
  }

 private:
  void widen(const Track& track);

  using Tag = std::uint32_t;  // twice the index of the make, and 1 where the sphere is not flying
  struct alignas(64) TurningAndEnd {
    Turning turning;
    double end = never;
  };

  Vector3<double> gravity_{0, 0, 0};
  double gravity_size_ = 0;
  double position_size_ = 0, velocity_size_ = 0;  // of what has been set, at most
  std::vector<Make> makes_;
  std::vector<Track> tracks_;
  std::vector<Tag> tags_;
  std::vector<TurningAndEnd> turnings_;
  std::vector<Vector3<double>> accelerations_;  // of those that are not flying; none before the first of them
};

}  // namespace carom::scene
