// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>

namespace carom::tests {

/// The scene files that ship, sorted by name.
[[nodiscard]] inline std::vector<std::filesystem::path> shipped_scenes() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes")) {
    if (entry.path().extension() == ".json") {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

[[nodiscard]] inline nlohmann::json json_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return parse_json(std::string(std::istreambuf_iterator<char>(file), {}));
}

/// A valid scene that tests change.
[[nodiscard]] inline nlohmann::json small_scene() {
  return parse_json(R"({
    "title": "Two balls over a floor", "law": "coulomb", "precision": "extended", "duration": 2, "gravity": [0, 0, -9.81],
    "capture_height": 1e-5,
    "materials": ["steel", "wood"],
    "contacts": [
      {"materials": ["steel", "wood"], "restitution": 0.5, "friction": 0.25, "tangential_restitution": -0.5,
       "rolling_resistance": 0.01, "spinning_resistance": 0.02},
      {"materials": ["steel", "steel"]}
    ],
    "room": {"least": [-4, -4, 0], "greatest": [4, 4, 8], "material": "wood"},
    "planes": [{"name": "ramp", "normal": [1, 0, 2], "point": [-4, 0, 0], "material": "wood"}],
    "spheres": [{"radius": 0.5, "density": 1000, "material": "steel", "position": [0, 0, 4], "velocity": [1, 2, 3]}],
    "lattices": [{"name": "row", "count": [3, 1, 1], "first": [-1, 2, 4], "spacing": [1, 0, 0], "radius": 0.5,
                  "density": 500, "material": "steel", "speed": 0.5, "seed": 7, "at_rest_as_a_whole": true}]
  })");
}

[[nodiscard]] inline nlohmann::json small_scene_with_polyhedra() {
  nlohmann::json scene = small_scene();
  scene["polyhedra"] = parse_json(R"([
    {"name": "box", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]],
     "density": 700, "material": "wood", "position": [2, -2.5, 2], "orientation": [0.1, -2, 0.3, 0.4],
     "velocity": [1, 2, 3], "angular_velocity": [4, 5, 6]},
    {"vertices": [[0.25, 0.25, 0.25], [0.25, -0.25, -0.25], [-0.25, 0.25, -0.25], [-0.25, -0.25, 0.25]],
     "density": 7800, "material": "steel", "position": [-1, -2, 6]}
  ])");
  scene["lattices"][0]["spacing"][0] = 1.25;  // in a scene with polyhedra, no bodies may touch
  scene["contacts"].push_back({{"materials", {"wood", "wood"}}, {"restitution", 0.25}});
  return scene;
}

}  // namespace carom::tests
