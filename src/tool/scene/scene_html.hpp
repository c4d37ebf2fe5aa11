// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "scene/scene_run.hpp"

namespace carom::tool {

/// The report.html of a scene, in the style of the gate's report: one page without script or network. The page is
/// well-formed XML, too. It links the pictures in its folder, and replay.html if `has_replay_beside`.
[[nodiscard]] std::string scene_html(const SceneRun& run, bool has_replay_beside);

}  // namespace carom::tool
