// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <carom/scene/event.hpp>
#include <carom/scene/scene_state.hpp>

namespace carom::tool {

struct Sample {
  double time = 0;                       // [s]
  double translation = 0, rotation = 0;  // kinetic energy [J]
  double potential = 0;                  // −m g·x, relative to the start [J]
  Vector3<double> momentum{0, 0, 0};     // [N s]
  double mean_spin = 0;                  // mean of ‖w‖ over the bodies [rad/s]

  [[nodiscard]] double total() const { return translation + rotation + potential; }
};

/// Samples at equal intervals of time, for pictures.
class SceneSamples {
 public:
  /// Begins at the start of a scene. Precondition: the scene that the state refers to outlives this object.
  SceneSamples(const scene::SceneState& state, std::size_t count);

  void record(const scene::Event& event);
  /// Samples up to `time`. Precondition: no event happens until then.
  void close(double time);
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

 private:
  void sample_until(double time);
  [[nodiscard]] Vector3<double> spin_at(std::size_t body, double time) const;
  void go_on(const scene::Change& change);

  const scene::Scene* scene_;
  std::vector<scene::BodyState> bodies_;
  double step_;
  double first_potential_ = 0;
  std::vector<Sample> samples_;
};

}  // namespace carom::tool
