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

RunResult validate(const std::string& scene) {
  static const std::string schema = std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/scene.schema.json";
  return run_program("/usr/bin/python3", {"-W", "ignore", "-m", "jsonschema", "-i", scene, schema});
}

TEST(SceneSchema, DescribesTheScenesThatShip) {
  const TemporaryDirectory directory;
  for (const auto& path : shipped_scenes()) {
    const RunResult shipped = validate(path.string());
    EXPECT_EQ(shipped.exit_status, 0) << path << shipped.output << shipped.errors;
    const json written = scene::scene_to_json(scene::scene_from_json(json_of(path)));
    if (written.at("spheres").size() < 1000) {  // python takes a minute for more
      const RunResult result = validate(directory.write("scene.json", written.dump()));
      EXPECT_EQ(result.exit_status, 0) << path << result.output << result.errors;
    }
  }
}

TEST(SceneSchema, RejectsWhatTheReaderDoes) {
  const TemporaryDirectory directory;
  ASSERT_EQ(validate(directory.write("scene.json", small_scene().dump())).exit_status, 0) << "else all is rejected";
  const std::vector<std::pair<const char*, std::function<void(json&)>>> changes{
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
  for (const auto& [name, change] : changes) {
    json changed = small_scene();
    change(changed);
    EXPECT_EQ(validate(directory.write("scene.json", changed.dump())).exit_status, 1) << name;
    EXPECT_THROW((void)scene::scene_from_json(changed), FormatError) << name;
  }
}

TEST(SceneSchema, AcceptsAndRejectsPolyhedraAsTheReaderDoes) {
  const TemporaryDirectory directory;
  const json scene = small_scene_with_polyhedra();
  ASSERT_EQ(validate(directory.write("scene.json", scene.dump())).exit_status, 0) << "else all is rejected";
  const json written = scene::scene_to_json(scene::scene_from_json(scene));
  EXPECT_EQ(validate(directory.write("scene.json", written.dump())).exit_status, 0);
  const std::vector<std::pair<const char*, std::function<void(json&)>>> changes{
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
  for (const auto& [name, change] : changes) {
    json changed = scene;
    change(changed["polyhedra"][0]);
    EXPECT_EQ(validate(directory.write("scene.json", changed.dump())).exit_status, 1) << name;
    EXPECT_THROW((void)scene::scene_from_json(changed), FormatError) << name;
  }
}

}  // namespace
}  // namespace carom::tests
