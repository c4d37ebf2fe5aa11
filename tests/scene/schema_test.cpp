// SPDX-License-Identifier: BSL-1.0

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/scene/json/scene_json.hpp>

#include "shipped.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

const std::string schema = std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/scene.schema.json";

using Changes = std::vector<std::pair<const char*, std::function<void(json&)>>>;

/// Checks that the schema and the reader accept the scene, and reject it after any of these changes.
void expect_rejected(const json& scene, const Changes& changes) {
  const TemporaryDirectory directory;
  const std::string unchanged = directory.write("unchanged", scene.dump());
  std::vector<std::string> files{unchanged};
  for (const auto& [name, change] : changes) {
    json changed = scene;
    change(changed);
    files.push_back(directory.write(name, changed.dump()));
    EXPECT_THROW((void)scene::scene_from_json(changed), FormatError) << name;
  }
  EXPECT_EQ(accepted_by(schema, files), std::vector{unchanged});
}

TEST(SceneSchema, DescribesTheScenesThatShip) {
  const TemporaryDirectory directory;
  std::vector<std::string> files;
  for (const auto& path : shipped_scenes()) {
    files.push_back(path.string());
    const json written = scene::scene_to_json(scene::scene_from_json(json_of(path)));
    if (written.at("spheres").size() < 1000) {  // python takes a minute for more
      files.push_back(directory.write(path.filename().string(), written.dump()));
    }
  }
  EXPECT_EQ(accepted_by(schema, files), files);
}

TEST(SceneSchema, RejectsWhatTheReaderDoes) {
  const Changes changes{
      {"no duration", [](json& s) { s.erase("duration"); }},
      {"a negative duration", [](json& s) { s["duration"] = -1; }},
      {"an unknown field", [](json& s) { s["mood"] = "good"; }},
      {"an unknown law", [](json& s) { s["law"] = "any"; }},
      {"slanting gravity", [](json& s) { s["gravity"][0] = 1; }},
      {"a number as text", [](json& s) { s["spheres"][0]["velocity"][0] = "nan"; }},
      {"two numbers",
       [](json& s) {
         s["spheres"][0]["position"] = {1, 2};
       }},
      {"no radius", [](json& s) { s["spheres"][0].erase("radius"); }},
      {"a radius of 0", [](json& s) { s["lattices"][0]["radius"] = 0; }},
      {"a material twice", [](json& s) { s["materials"][1] = "steel"; }},
      {"a restitution of 2", [](json& s) { s["contacts"][0]["restitution"] = 2; }},
      {"a normal of 0",
       [](json& s) {
         s["planes"][0]["normal"] = {0, 0, 0};
       }},
      {"a count of 0", [](json& s) { s["lattices"][0]["count"][0] = 0; }},
      {"a seed that is none", [](json& s) { s["lattices"][0]["seed"] = -1; }},
  };
  expect_rejected(small_scene(), changes);
}

TEST(SceneSchema, AcceptsAndRejectsPolyhedraAsTheReaderDoes) {
  const TemporaryDirectory directory;
  const json scene = small_scene_with_polyhedra();
  const json written = scene::scene_to_json(scene::scene_from_json(scene));
  const std::string file = directory.write("scene.json", written.dump());
  EXPECT_EQ(accepted_by(schema, {file}), std::vector{file});
  const Changes of_a_polyhedron{
      {"no vertices", [](json& p) { p.erase("vertices"); }},
      {"three vertices",
       [](json& p) {
         p["vertices"] = std::vector<json>(3, {0, 0, 0});
       }},
      {"1001 vertices",
       [](json& p) {
         p["vertices"] = std::vector<json>(1001, {0, 0, 0});
       }},
      {"a vertex of two numbers",
       [](json& p) {
         p["vertices"][0] = {1, 2};
       }},
      {"a density of 0", [](json& p) { p["density"] = 0; }},
      {"no position", [](json& p) { p.erase("position"); }},
      {"an orientation of three numbers",
       [](json& p) {
         p["orientation"] = {1, 0, 0};
       }},
      {"an orientation of zeros",
       [](json& p) {
         p["orientation"] = {0, 0, 0, 0};
       }},
      {"a velocity as text", [](json& p) { p["velocity"][0] = "inf"; }},
      {"a radius", [](json& p) { p["radius"] = 1; }},
      {"a number for a name", [](json& p) { p["name"] = 1; }},
  };
  Changes changes;
  for (const auto& [name, change] : of_a_polyhedron) {
    changes.emplace_back(name, [&change](json& s) { change(s["polyhedra"][0]); });
  }
  expect_rejected(scene, changes);
}

}  // namespace
}  // namespace carom::tests
