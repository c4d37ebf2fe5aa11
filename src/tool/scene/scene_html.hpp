// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "scene/scene_run.hpp"

namespace carom::tool {

/// report.html of a scene, in the way of the gate's: one page, without script or network, well-formed XML as well. It
/// links replay.html, where that is beside it, and shows the pictures that are.
[[nodiscard]] std::string scene_html(const SceneRun& run, bool has_replay_beside);

}  // namespace carom::tool
