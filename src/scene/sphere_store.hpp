// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <carom/collision/expects.hpp>
#include <carom/scene/arc.hpp>
#include <carom/scene/prediction.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// The common properties of spheres with the same radius, density and material.
struct SphereType {
  double radius;         // [m]
  double mass;           // [kg]
  double moment;         // (2/5) m R² [kg m²]
  std::size_t material;  // index into Scene::materials
};

/// The data of a sphere that each of its neighbours reads: one cache line. The acceleration is gravity unless the
/// sphere is on a plane.
struct alignas(64) Track {
  Vector3<double> position{0, 0, 0};
  double start = 0;  // of the path [s]
  Vector3<double> velocity{0, 0, 0};
  double until = never;  // end of the path or time of leaving the cell, the earlier of the two [s]
};
static_assert(sizeof(Track) == 64);

/// Bounds of the 1-norms of all positions [m] and velocities [m/s].
struct Extent {
  double position_size, velocity_size;
};

/// The motions of all spheres of a scene. In a large scene, an event reads memory that is in no cache. So data that is
/// read together is stored together, and spheres share the data of their type.
class SphereStore {
 public:
  using Index = std::uint32_t;

  SphereStore() = default;
  /// All spheres are flying, as at the beginning of the scene.
  explicit SphereStore(const Scene& scene);

  [[nodiscard]] std::size_t size() const { return tracks_.size(); }
  [[nodiscard]] const std::vector<SphereType>& types() const { return types_; }
  [[nodiscard]] std::size_t type_index(std::size_t sphere) const { return tags_[sphere] / 2; }
  [[nodiscard]] const SphereType& type(std::size_t sphere) const { return types_[type_index(sphere)]; }
  [[nodiscard]] const Track& track(std::size_t sphere) const { return tracks_[sphere]; }
  [[nodiscard]] bool is_flying(std::size_t sphere) const { return tags_[sphere] % 2 == 0; }
  /// The index of the plane that the sphere is on. Precondition: the sphere is not flying.
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
    path.radius = type(sphere).radius;
    measure(path);
    return path;
  }
  /// Upper bounds, except for a few roundings, of the 1-norms of all positions and velocities up to `now`.
  /// Accelerations on planes are ignored.
  [[nodiscard]] Extent extent(double now) const {
    const double turn = gravity_size_ * now;
    return {position_size_ + now * (velocity_size_ + turn), velocity_size_ + turn};
  }
  [[nodiscard]] Arc arc(std::size_t sphere) const { return {path(sphere), turnings_[sphere].turning}; }
  /// Preconditions: the radius is that of the sphere's type; if the arc is flying, its acceleration is gravity and its
  /// end is `never`.
  void set_arc(std::size_t sphere, const Arc& arc);
  void set_position(std::size_t sphere, const Vector3<double>& position);
  void set_until(std::size_t sphere, double until) { tracks_[sphere].until = until; }

  /// Prefetches the data of a flying sphere that `track` and `acceleration` read.
  void prefetch(std::size_t sphere) const {
    __builtin_prefetch(&tracks_[sphere]);
    __builtin_prefetch(&tags_[sphere]);
  }

  [[nodiscard]] std::size_t bytes_per_sphere() const {
    return sizeof(Track) + sizeof(TurningAndEnd) + sizeof(Tag) + (accelerations_.empty() ? 0 : sizeof(Vector3<double>));
  }

 private:
  void widen(const Track& track);

  using Tag = std::uint32_t;  // twice the index of the type, plus 1 if the sphere is not flying
  struct alignas(64) TurningAndEnd {
    Turning turning;
    double end = never;
  };

  Vector3<double> gravity_{0, 0, 0};
  double gravity_size_ = 0;
  double position_size_ = 0, velocity_size_ = 0;  // greatest 1-norms of the values set so far
  std::vector<SphereType> types_;
  std::vector<Track> tracks_;
  std::vector<Tag> tags_;
  std::vector<TurningAndEnd> turnings_;
  std::vector<Vector3<double>> accelerations_;  // of spheres that are not flying; empty until a sphere stops flying
};

/// A fast test of the flying neighbours of a flying sphere. It finds neighbours that certainly neither overlap the
/// sphere now nor touch it before the horizon. It is faster than `stay_apart`, because all neighbours share one wider
/// bound of rounding errors.
///
/// Let u be `roundoff`, P and W the bounds of positions and velocities in `Extent`, and R the sum of the radii. Let d
/// be the relative position and v the relative velocity, with 1-norms of at most 2 P and 2 W. Up to a relative 10⁻⁶,
/// these are bounds of the errors of computed numbers, here and in `RelativeState`:
/// - d: 2 · 7 u P + 2 u · 2 P = 18 u P.
/// - v: 2 · 4 u W + 2 u · 2 W = 12 u W.
/// - d·v: 2 P · 12 u W + 2 W · 18 u P + 4 u · 2 P · 2 W = 76 u P W.
///
/// So the tests are certain:
/// - Receding: the test is d·v > 128 u P W as computed. If the test passes, the exact d·v is positive.
/// - Far: the test is |d| > R + m + (‖v‖₁ + 16 u W) s as computed, with m = 256 u (P + R) and the time s to the
///   horizon. If the test passes, both sides are at most 2 P. Fewer than 8 roundings cost at most 16 u P, and d has an
///   error of 18 u P. The sum is below m.
/// - No overlap: if |d| > R + m, then |d|² − R² > (|d| + R) m. The error of the squared gap in `RelativeState` is
///   smaller: at most (2√3 |d| + 18 u P) 18 u P + 8 u (3 |d|² + R²) ≤ (|d| + R) (130 u P + 8 u R).
class QuickLook {
 public:
  /// For a sphere of this radius that is `here` at `now`.
  QuickLook(const PathState& here, double radius, const Vector3<double>& gravity, const Extent& extent, double now,
            double horizon)
      : here_(here),
        gravity_(gravity),
        now_(now),
        horizon_(horizon),
        radius_(radius),
        margin_(256 * roundoff * extent.position_size),
        velocity_margin_(16 * roundoff * extent.velocity_size),
        receding_margin_(128 * roundoff * extent.position_size * extent.velocity_size) {}

  [[nodiscard]] bool stays_apart(const Track& other, double its_radius) const {
    const double s = now_ - other.start;
    const Vector3<double> position = other.position + s * (other.velocity + (0.5 * s) * gravity_);
    const Vector3<double> distance = here_.position - position;
    const Vector3<double> velocity = here_.velocity - (other.velocity + s * gravity_);
    const double span = std::max(0.0, std::min(horizon_, other.until) - now_);
    const double touching = (radius_ + its_radius) * (1 + 256 * roundoff) + margin_;
    const double reach = touching + (velocity.cwiseAbs().sum() + velocity_margin_) * span;
    const double square = distance.dot(distance);
    const bool is_far = square > reach * reach;
    const bool recedes = distance.dot(velocity) > receding_margin_;
    return is_far | (recedes & (square > touching * touching));
  }

 private:
  PathState here_;
  Vector3<double> gravity_;
  double now_, horizon_, radius_, margin_, velocity_margin_, receding_margin_;
};

}  // namespace carom::scene
