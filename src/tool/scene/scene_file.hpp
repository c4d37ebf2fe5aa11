// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/scene/scene.hpp>

namespace carom::tool {

/// The scene that a text holds; without a title it has the file's name. Throws UsageError that names the file, the
/// place in it, and what was expected.
[[nodiscard]] scene::Scene scene_of(const std::string& text, const std::string& file);

}  // namespace carom::tool
