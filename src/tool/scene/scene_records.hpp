// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "scene/scene_run.hpp"

namespace carom::tool {

/// scene.json: what came of a run (docs/guide/scenes.md).
[[nodiscard]] nlohmann::json scene_record(const SceneRun& run);

/// The title of a scene, safe to print in a line; "scene" where it has none.
[[nodiscard]] std::string shown_title(const scene::Scene& scene);

/// What `carom scene` prints.
[[nodiscard]] std::string scene_text(const SceneRun& run);

/// The run in one line.
[[nodiscard]] std::string scene_verdict(const SceneRun& run);

/// What the page of replays takes (docs/reference/replay.md). Precondition: run.replayed().
[[nodiscard]] nlohmann::json replay_record(const SceneRun& run);

/// The first line of events.csv, and the line of an event: its number, kind, bodies, and what each body was left with,
/// every number so that reading it gives the same bits. Orientations at the event stand last, where the scene has
/// polyhedra.
[[nodiscard]] std::string events_csv_header(const scene::Scene& scene);
[[nodiscard]] std::string events_csv_line(const scene::Scene& scene, std::uint64_t number, const scene::Event& event);

/// series.csv: the samples.
[[nodiscard]] std::string series_csv(const SceneRun& run);

}  // namespace carom::tool
