// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <carom/scene/simulation.hpp>

namespace carom::properties {

/// How each body has moved over a span of time: all that a checker is given of a run.
class History {
 public:
  /// From the state's time on.
  explicit History(const scene::SceneState& state)
      : begin_(state.time), end_(state.time), first_polyhedron_(state.scene->spheres.size()) {
    for (const scene::BodyState& body : state.bodies) {
      arcs_.push_back({body.arc});
      orientations_.emplace_back();
      if (arcs_.size() > first_polyhedron_) {
        orientations_.back().push_back(body.orientation_at_start);
      }
    }
  }

  void record(const scene::Event& event) {
    end_ = event.time;
    record(event.a);
    if (event.b) {
      record(*event.b);
    }
  }

  /// No more happens until then.
  void end_at(double time) { end_ = time; }

  [[nodiscard]] double begin() const { return begin_; }
  [[nodiscard]] double end() const { return end_; }
  /// Of each body, in order of time: each holds from its start, or from `begin`, to the next one's start, or to
  /// `end`.
  [[nodiscard]] const std::vector<std::vector<scene::Arc>>& arcs() const { return arcs_; }
  /// Of each polyhedron, at the start of each of its arcs: body axes to world axes. Nothing of spheres.
  [[nodiscard]] const std::vector<std::vector<Quaternion<double>>>& orientations() const { return orientations_; }

 private:
  void record(const scene::Change& change) {
    arcs_[change.body].push_back(change.after);
    if (change.body >= first_polyhedron_) {
      orientations_[change.body].push_back(change.orientation);
    }
  }

  double begin_, end_;
  std::size_t first_polyhedron_;
  std::vector<std::vector<scene::Arc>> arcs_;
  std::vector<std::vector<Quaternion<double>>> orientations_;
};

}  // namespace carom::properties
