// SPDX-License-Identifier: BSL-1.0

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/scene/json/scene_json.hpp>

#include "scene_files.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

const std::string schema = std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/scene.schema.json";

TEST(SceneSchema, AcceptsTheScenesThatShipAndWhatTheWriterWrites) {
  const TemporaryDirectory directory;
  std::vector<std::string> files{
      directory.write("small", scene::scene_to_json(scene::scene_from_json(small_scene())).dump())};
  for (const auto& path : shipped_scenes()) {
    files.push_back(path.string());
    const json written = scene::scene_to_json(scene::scene_from_json(json_of(path)));
    if (written.at("spheres").size() < 1000) {  // python takes a minute for more
      files.push_back(directory.write(path.filename().string(), written.dump()));
    }
  }
  EXPECT_EQ(accepted_by(schema, files), files);
}

TEST(SceneSchema, RejectsWhatTheReaderRejectsUnlessItCannotStateTheCondition) {
  const TemporaryDirectory directory;
  std::vector<std::string> files{directory.write("unchanged", small_scene().dump())};
  std::vector<std::string> accepted = files;
  for (const Refusal& refusal : refusals()) {
    files.push_back(directory.write(std::to_string(files.size()) + ".json", refusal.scene().dump()));
    if (refusal.is_beyond_schema) {
      accepted.push_back(files.back());
    }
  }
  EXPECT_EQ(accepted_by(schema, files), accepted);
}

}  // namespace
}  // namespace carom::tests
