// SPDX-License-Identifier: BSL-1.0
#include "scene/scene_samples.hpp"

#include <algorithm>

#include <carom/scene/polyhedra/free_rotation.hpp>

namespace carom::tool {

SceneSamples::SceneSamples(const scene::SceneState& state, std::size_t count)
    : scene_(state.scene),
      bodies_(state.bodies),
      step_(state.scene->duration / static_cast<double>(std::max<std::size_t>(count, 1))) {}

Vector3<double> SceneSamples::spin_at(std::size_t body, double time) const {
  const scene::BodyState& state = bodies_[body];
  if (is_sphere(*scene_, body) || state.arc.turning.angular_velocity.isZero(0)) {
    return angular_velocity_at(state.arc, time);
  }
  const double elapsed = time - state.arc.path.start;
  const scene::RotationPath path(state.principal_inertia,
                                 scene::rotation_state(state.orientation_at_start, state.arc.turning.angular_velocity),
                                 elapsed);
  return scene::world_rate(path.at(elapsed).state);
}

void SceneSamples::sample_until(double time) {
  for (double next = static_cast<double>(samples_.size()) * step_; next <= time && (step_ > 0 || samples_.empty());
       next = static_cast<double>(samples_.size()) * step_) {
    Sample sample;
    sample.time = next;
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      const scene::BodyState& state = bodies_[body];
      const scene::Arc& arc = state.arc;
      const Vector3<double> velocity = scene::velocity_at(arc.path, next);
      const Vector3<double> spin = spin_at(body, next);
      sample.translation += state.mass * velocity.squaredNorm() / 2;
      // The energy of a free rotation is constant between events, so it is computed at the start of the arc.
      const Vector3<double> rate =
          is_sphere(*scene_, body)
              ? spin
              : scene::rotation_state(state.orientation_at_start, arc.turning.angular_velocity).body_rate;
      sample.rotation += state.principal_inertia.dot(rate.cwiseAbs2()) / 2;
      sample.potential -= state.mass * scene_->gravity.dot(scene::position_at(arc.path, next));
      sample.momentum += state.mass * velocity;
      sample.mean_spin += spin.norm() / static_cast<double>(bodies_.size());
    }
    if (samples_.empty()) {
      first_potential_ = sample.potential;
    }
    sample.potential -= first_potential_;
    samples_.push_back(sample);
  }
}

void SceneSamples::go_on(const scene::Change& change) {
  bodies_[change.body].arc = change.after;
  bodies_[change.body].orientation_at_start = change.orientation;
}

void SceneSamples::record(const scene::Event& event) {
  sample_until(event.time);
  go_on(event.a);
  if (event.b) {
    go_on(*event.b);
  }
}

void SceneSamples::close(double time) { sample_until(time); }

}  // namespace carom::tool
