// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

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
  WatchedRun(
      scene::Scene of, std::size_t most_events, const Alter& alter = [](scene::Event&) { return true; })
      : simulation(std::move(of)),
        first(simulation.state()),
        history(first),
        ledger(first),
        judge(simulation.scene().law, simulation.scene().precision, 1, {}) {
    for (std::size_t k = 0; k < most_events; ++k) {
      const scene::Event* const next = next_event();
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

  [[nodiscard]] properties::Validity validity() const {
    return properties::check_validity(simulation.scene(), history);
  }
  /// Σ |rounding| of the energy, relative to the ledger's scale.
  [[nodiscard]] long double relative_rounding() const { return ledger.rounding_without_signs() / ledger.scale(); }

  /// The next event; null at the end, or if bodies would have to rest on each other.
  [[nodiscard]] const scene::Event* next_event() {
    try {
      return simulation.advance();
    } catch (const scene::SceneError& error) {
      EXPECT_NE(std::string(error.what()).find("would have to rest"), std::string::npos) << error.what();
      return nullptr;
    }
  }

  /// The widest gap at an impact of spheres, relative to the sum of their radii.
  double widest_gap = 0;
  scene::SceneSimulation simulation;
  scene::SceneState first;
  properties::History history;
  properties::Ledger ledger;
  properties::ImpulseJudge judge;
};

/// Whether a violation's other body and its words contain these texts.
[[nodiscard]] inline bool has(const properties::Validity& validity, const std::string& other, const std::string& what) {
  return std::any_of(validity.invalid.begin(), validity.invalid.end(), [&](const properties::Invalidity& one) {
    return one.other.find(other) != std::string::npos && one.what.find(what) != std::string::npos;
  });
}

[[nodiscard]] inline std::string text_of(const properties::Validity& validity) {
  std::string text;
  for (const properties::Invalidity& one : validity.invalid) {
    text += "body " + std::to_string(one.body) + " and " + one.other + " from " + std::to_string(one.begin) + " to " +
            std::to_string(one.end) + ": " + one.what + "\n";
  }
  return text;
}

/// Checks that the run is valid, that its ledger closes, and that each impulse passes.
inline properties::Validity expect_sound(const WatchedRun& run) {
  const properties::Validity validity = run.validity();
  EXPECT_EQ(validity.count, 0U) << text_of(validity);
  const properties::Ledger& ledger = run.ledger;
  EXPECT_TRUE(ledger.is_closed()) << ledger.worst_rounding();
  long double sum = ledger.initial().total();
  for (const properties::Cause cause : properties::all_causes) {
    sum += ledger.energy(cause);
  }
  EXPECT_NEAR(static_cast<double>(sum / ledger.scale()), static_cast<double>(ledger.present().total() / ledger.scale()),
              1e-15);
  long double mass = 0;
  for (const scene::BodyState& body : run.first.bodies) {
    mass += body.mass;
  }
  // Bodies of the mass m and the energy E have a momentum of at most √(2 m E).
  EXPECT_LE(ledger.momentum_rounding().norm(), 1e-12L * std::sqrt(2 * mass * ledger.scale()));
  EXPECT_EQ(run.judge.violated(), 0U) << run.judge.first_bad()->invariant << " at " << run.judge.first_bad()->time;
  EXPECT_EQ(run.judge.judged(), run.judge.impulses());
  return validity;
}

}  // namespace carom::unit
