// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <carom/scene/simulation.hpp>

namespace carom::properties {

/// How each sphere has moved over a span of time: all that a checker is given of a run.
class History {
 public:
  /// From the simulation's present on.
  explicit History(const scene::Simulation& simulation) : begin_(simulation.time()), end_(simulation.time()) {
    for (std::size_t sphere = 0; sphere < simulation.size(); ++sphere) {
      arcs_.push_back({simulation.arc(sphere)});
    }
  }

  void record(const scene::Event& event) {
    end_ = event.time;
    arcs_[event.a.sphere].push_back(event.a.after);
    if (event.b) {
      arcs_[event.b->sphere].push_back(event.b->after);
    }
  }

  /// No more happens until then.
  void end_at(double time) { end_ = time; }

  [[nodiscard]] double begin() const { return begin_; }
  [[nodiscard]] double end() const { return end_; }
  /// Of each sphere, in order of time: each holds from its start, or from `begin`, to the next one's start, or to
  /// `end`.
  [[nodiscard]] const std::vector<std::vector<scene::Arc>>& arcs() const { return arcs_; }

 private:
  double begin_, end_;
  std::vector<std::vector<scene::Arc>> arcs_;
};

}  // namespace carom::properties
