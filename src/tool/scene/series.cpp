// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/series.hpp"

#include <algorithm>

namespace carom::tool {

Series::Series(const scene::Simulation& simulation, std::size_t count)
    : simulation_(&simulation),
      step_(simulation.scene().duration / static_cast<double>(std::max<std::size_t>(count, 1))) {
  for (std::size_t sphere = 0; sphere < simulation.size(); ++sphere) {
    arcs_.push_back(simulation.arc(sphere));
  }
}

void Series::sample_until(double time) {
  for (double next = static_cast<double>(samples_.size()) * step_; next <= time && (step_ > 0 || samples_.empty());
       next = static_cast<double>(samples_.size()) * step_) {
    Sample sample;
    sample.time = next;
    for (std::size_t sphere = 0; sphere < arcs_.size(); ++sphere) {
      const scene::Arc& arc = arcs_[sphere];
      const double mass = simulation_->mass(sphere);
      const Vector3<double> velocity = scene::velocity_at(arc.path, next);
      const Vector3<double> spin = scene::angular_velocity_at(arc, next);
      sample.translation += mass * velocity.squaredNorm() / 2;
      sample.rotation += simulation_->moment(sphere) * spin.squaredNorm() / 2;
      sample.potential -= mass * simulation_->scene().gravity.dot(scene::position_at(arc.path, next));
      sample.momentum += mass * velocity;
      sample.mean_spin += spin.norm() / static_cast<double>(arcs_.size());
    }
    if (samples_.empty()) {
      first_potential_ = sample.potential;
    }
    sample.potential -= first_potential_;
    samples_.push_back(sample);
  }
}

void Series::record(const scene::Event& event) {
  sample_until(event.time);
  arcs_[event.a.sphere] = event.a.after;
  if (event.b) {
    arcs_[event.b->sphere] = event.b->after;
  }
}

void Series::close(double time) { sample_until(time); }

}  // namespace carom::tool
