// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>
#include <numbers>
#include <tuple>

#include <carom/collision/expects.hpp>
#include <carom/scene/sphere_store.hpp>

namespace carom::scene {

SphereStore::SphereStore(const Scene& scene)
    : gravity_(scene.gravity),
      gravity_size_(scene.gravity.cwiseAbs().sum()),
      tracks_(scene.spheres.size()),
      turnings_(scene.spheres.size()) {
  std::map<std::tuple<double, double, std::size_t>, Tag> tags;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const Sphere& sphere = scene.spheres[i];
    const auto [tag, is_new] =
        tags.try_emplace({sphere.radius, sphere.density, sphere.material}, static_cast<Tag>(2 * types_.size()));
    if (is_new) {
      const double mass =
          sphere.density * (4.0 / 3.0) * std::numbers::pi * sphere.radius * sphere.radius * sphere.radius;
      types_.push_back({sphere.radius, mass, 0.4 * mass * sphere.radius * sphere.radius, sphere.material});
    }
    tags_.push_back(tag->second);
    tracks_[i].position = sphere.position;
    tracks_[i].velocity = sphere.velocity;
    widen(tracks_[i]);
    turnings_[i].turning.angular_velocity = sphere.angular_velocity;
  }
}

void SphereStore::set_arc(std::size_t sphere, const Arc& arc) {
  const bool is_flying = arc.turning.phase == Phase::flying;
  CAROM_EXPECTS(arc.path.radius == type(sphere).radius, arc.path.radius, type(sphere).radius);
  CAROM_EXPECTS(!is_flying || (arc.path.acceleration == gravity_ && arc.path.end == never), arc.path.acceleration,
                arc.path.end);
  tags_[sphere] = tags_[sphere] / 2 * 2 + (is_flying ? 0 : 1);
  tracks_[sphere] = {arc.path.position, arc.path.start, arc.path.velocity, arc.path.end};
  widen(tracks_[sphere]);
  turnings_[sphere] = {arc.turning, arc.path.end};
  if (!is_flying) {
    accelerations_.resize(tracks_.size());
    accelerations_[sphere] = arc.path.acceleration;
  }
}

void SphereStore::set_position(std::size_t sphere, const Vector3<double>& position) {
  tracks_[sphere].position = position;
  widen(tracks_[sphere]);
}

void SphereStore::widen(const Track& track) {
  position_size_ = std::max(position_size_, track.position.cwiseAbs().sum());
  velocity_size_ = std::max(velocity_size_, track.velocity.cwiseAbs().sum());
}

}  // namespace carom::scene
