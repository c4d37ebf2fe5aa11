// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/report/pictures/plot.hpp>

#include "scene/scene_run.hpp"

namespace carom::tool {

/// The scene.json of a run (docs/guide/scenes.md).
[[nodiscard]] nlohmann::json scene_record(const SceneRun& run);

/// The title of a scene, safe to print in one line; "scene" if it has none.
[[nodiscard]] std::string shown_title(const scene::Scene& scene);

/// The output of `carom scene`.
[[nodiscard]] std::string scene_text(const SceneRun& run);

/// The verdict of the run in one line.
[[nodiscard]] std::string scene_verdict(const SceneRun& run);

/// The data for the page of replays (docs/reference/replay.md). Precondition: run.replayed() has a value.
[[nodiscard]] nlohmann::json replay_record(const SceneRun& run);

/// The header of events.csv, and the line of an event. A line has the event's number, kind and bodies, and the state of
/// each body after the event. Every number round-trips to the same bits. If the scene has polyhedra, their orientations
/// at the event are the last columns.
[[nodiscard]] std::string events_csv_header(const scene::Scene& scene);
[[nodiscard]] std::string events_csv_line(const scene::Scene& scene, std::uint64_t number, const scene::Event& event);

[[nodiscard]] std::string series_csv(const SceneRun& run);

/// The report.html of a scene, in the style of the gate's report: one page without script or network. The page is
/// well-formed XML, too. It links the pictures in its folder, and replay.html if `has_replay_beside`.
[[nodiscard]] std::string scene_html(const SceneRun& run, bool has_replay_beside);

struct SampledLaw {
  std::string law;
  std::vector<Sample> samples;
};

/// Energy over time [J]. For one law: the parts of the energy, and the lost energy. For several laws: the total under
/// each law.
[[nodiscard]] report::Plot energy_plot(std::span<const SampledLaw> laws);
/// Momentum over time [N s]. For one law: the components. For several laws: the magnitude under each law.
[[nodiscard]] report::Plot momentum_plot(std::span<const SampledLaw> laws);
/// The mean of ‖w‖ over the bodies [rad/s], for each law.
[[nodiscard]] report::Plot spin_plot(std::span<const SampledLaw> laws);

}  // namespace carom::tool
