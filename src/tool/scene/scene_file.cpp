// SPDX-License-Identifier: BSL-1.0
#include "scene/scene_file.hpp"

#include <filesystem>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/scene/json/scene_json.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {

scene::Scene scene_of(const std::string& text, const std::string& file) {
  try {
    scene::Scene scene = scene::scene_from_json(parse_json(text));
    if (scene.title.empty()) {
      scene.title = std::filesystem::path(file).stem().string();
    }
    return scene;
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace carom::tool
