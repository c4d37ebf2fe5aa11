// SPDX-License-Identifier: BSL-1.0
#include "scene/scene_file.hpp"

#include <filesystem>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/scene/json/scene_json.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {

bool is_scene(const std::string& text) {
  try {
    const nlohmann::json json = parse_json(text);
    return json.is_object() && json.contains("duration");
  } catch (const FormatError&) {
    return false;  // JSON Lines, or what whoever reads it says better
  }
}

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
