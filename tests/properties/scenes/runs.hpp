// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <carom/properties/scenes/history.hpp>
#include <carom/properties/scenes/judged_impulses.hpp>
#include <carom/properties/scenes/ledger.hpp>
#include <carom/properties/scenes/validity.hpp>
#include <carom/scene/polyhedra/scene_simulation.hpp>

#include "scene/scenes.hpp"

namespace carom::unit {

/// Changes an event before the checkers receive it. Returns false to withhold the event from them.
using Alter = std::function<bool(scene::Event&)>;

template <class Change>
[[nodiscard]] Alter first_impact(Change change) {
  return [change, done = false](scene::Event& event) mutable {
    if (done || event.kind != scene::EventKind::impact) {
      return true;
    }
    done = true;
    return change(event);
  };
}

struct WatchedRun {
  WatchedRun(scene::Scene of, std::size_t most_events, const Alter& alter)
      : simulation(std::move(of)),
        first(simulation.state()),
        history(first),
        ledger(first),
        judge(simulation.scene().law, simulation.scene().precision, 1, {}) {
    for (std::size_t k = 0; k < most_events; ++k) {
      const scene::Event* const next = simulation.advance();
      if (next == nullptr) {
        break;
      }
      scene::Event event = *next;
      if (event.b) {
        const scene::Path& a = event.a.after.path;
        const scene::Path& b = event.b->after.path;
        const double distance = (a.position - b.position).norm();
        widest_gap = std::max(widest_gap, distance / (a.radius + b.radius) - 1);
      }
      if (!alter(event)) {
        continue;
      }
      history.record(event);
      ledger.record(event);
      judge.record(event);
    }
    history.end_at(simulation.time());
    ledger.close(simulation.state());
  }
  WatchedRun(scene::Scene of, std::size_t most_events)
      : WatchedRun(std::move(of), most_events, [](scene::Event&) { return true; }) {}

  [[nodiscard]] properties::Validity validity() const {
    return properties::check_validity(simulation.scene(), history);
  }
  /// Σ |rounding| of the energy, relative to the ledger's scale.
  [[nodiscard]] long double relative_rounding() const { return ledger.rounding_without_signs() / ledger.scale(); }

  /// The widest gap at an impact of spheres, relative to the sum of their radii.
  double widest_gap = 0;
  scene::SceneSimulation simulation;
  scene::SceneState first;
  properties::History history;
  properties::Ledger ledger;
  properties::ImpulseJudge judge;
};

}  // namespace carom::unit
