// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/scene/scene.hpp>

namespace carom::tool {

/// The scene in a text. A scene without a title gets the name of the file. Throws UsageError, which names the file, the
/// place and the expected content.
[[nodiscard]] scene::Scene scene_of(const std::string& text, const std::string& file);

}  // namespace carom::tool
