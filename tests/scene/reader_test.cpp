// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/scene/json/scene_json.hpp>

#include "scene_files.hpp"

namespace carom::scene {
namespace {

using nlohmann::json;
using tests::small_scene;

/// The reader's error; empty if there is none.
std::string error_of(const json& file) {
  try {
    (void)scene_from_json(file);
  } catch (const FormatError& error) {
    return error.what();
  }
  return {};
}

TEST(SceneJson, ReadsEveryFieldOfASceneOfSpheres) {
  const Scene scene = scene_from_json(small_scene());
  EXPECT_EQ(scene.title, "Two balls over a floor");
  EXPECT_EQ(scene.law, Law::coulomb);
  EXPECT_EQ(scene.precision, Precision::extended);
  EXPECT_EQ(scene.duration, 2);
  EXPECT_EQ(scene.gravity, Vector3<double>(0, 0, -9.81));
  EXPECT_EQ(scene.capture_height, 1e-5);
  EXPECT_EQ(scene.materials, (std::vector<std::string>{"steel", "wood"}));
  const MaterialPair& pair = scene.pairs.of(1, 0);
  EXPECT_EQ(pair.restitution, 0.5);
  EXPECT_EQ(pair.friction, 0.25);
  EXPECT_EQ(pair.tangential_restitution, -0.5);
  EXPECT_EQ(pair.rolling_resistance, 0.01);
  EXPECT_EQ(pair.spinning_resistance, 0.02);
  EXPECT_EQ(scene.pairs.of(0, 0).restitution, 1);
  ASSERT_EQ(scene.planes.size(), 7);
  EXPECT_EQ(scene.planes[0].name, "room -x");
  EXPECT_EQ(scene.planes[5].name, "room +z");
  EXPECT_EQ(scene.planes[5].normal, Vector3<double>(0, 0, -1));
  EXPECT_EQ(scene.planes[5].point[2], 8);
  EXPECT_EQ(scene.planes[5].material, 1);
  EXPECT_EQ(scene.planes[6].name, "ramp");
  ASSERT_EQ(scene.spheres.size(), 4);
  EXPECT_EQ(scene.spheres[0].name, "sphere 0");
  EXPECT_EQ(scene.spheres[0].velocity, Vector3<double>(1, 2, 3));
  EXPECT_EQ(scene.spheres[3].name, "row 2");
  EXPECT_EQ(scene.spheres[3].position, Vector3<double>(1.5, 2, 4));
  const Vector3<double> sum = scene.spheres[1].velocity + scene.spheres[2].velocity + scene.spheres[3].velocity;
  EXPECT_LT(sum.norm(), 1e-15);
}

TEST(SceneJson, ReadsEveryFieldOfAPolyhedron) {
  const Scene scene = scene_from_json(small_scene());
  ASSERT_EQ(scene.polyhedra.size(), 2);
  const Polyhedron& box = scene.polyhedra[0];
  EXPECT_EQ(box.name, "box");
  ASSERT_EQ(box.vertices.size(), 8);
  EXPECT_EQ(box.vertices[6], Vector3<double>(0, 1, 1));
  EXPECT_EQ(box.density, 700);
  EXPECT_EQ(box.material, 1);
  EXPECT_EQ(box.position, Vector3<double>(2, -2.5, 2));
  EXPECT_EQ(box.orientation, Quaternion<double>(0.1, -2, 0.3, 0.4));
  EXPECT_EQ(box.velocity, Vector3<double>(1, 2, 3));
  EXPECT_EQ(box.angular_velocity, Vector3<double>(4, 5, 6));
  const Polyhedron& other = scene.polyhedra[1];
  EXPECT_EQ(other.name, "polyhedron 1");
  EXPECT_EQ(other.material, 0);
  EXPECT_EQ(other.orientation, Quaternion<double>(1, 0, 0, 0));
  EXPECT_TRUE(other.velocity.isZero(0));
  EXPECT_TRUE(other.angular_velocity.isZero(0));
}

TEST(SceneJson, ReadsDefaultsOfFieldsThatAreAbsent) {
  const Scene scene = scene_from_json(json::parse(
      R"({"duration": 0, "planes": [{"normal": [0, 0, 2], "point": [0, 0, 0]}],
          "spheres": [{"radius": 1, "density": 1, "position": [0, 0, 1]}, {"radius": 1, "density": 1, "position": [2, 0, 1]}]})"));
  EXPECT_EQ(scene.law, Law::rough);
  EXPECT_EQ(scene.precision, Precision::binary64);
  EXPECT_TRUE(scene.gravity.isZero(0));
  EXPECT_EQ(scene.capture_height, default_capture_height);
  EXPECT_EQ(scene.materials, std::vector<std::string>{"default"});
  EXPECT_EQ(scene.pairs.of(0, 0).restitution, 1);
  EXPECT_EQ(scene.planes[0].name, "plane 0");
  EXPECT_EQ(scene.spheres[1].name, "sphere 1");
}

TEST(SceneJson, ReadsWhatItWrote) {
  std::vector<json> files{small_scene()};
  for (const auto& path : tests::shipped_scenes()) {
    files.push_back(tests::json_of(path));
  }
  EXPECT_EQ(files.size(), 8);
  for (const json& file : files) {
    const json written = scene_to_json(scene_from_json(file));
    EXPECT_EQ(scene_to_json(scene_from_json(parse_json(written.dump()))).dump(), written.dump()) << file.at("title");
    EXPECT_EQ(written.at("title"), file.at("title"));
    EXPECT_EQ(written.contains("polyhedra"), file.contains("polyhedra"));
  }
}

TEST(SceneJson, DrawsTheVelocitiesThatAnotherProgramDraws) {
  json file = small_scene();
  file["lattices"][0]["at_rest_as_a_whole"] = false;
  const Scene scene = scene_from_json(file);
  // Another program computed this velocity from the seed 7.
  EXPECT_EQ(scene.spheres[1].velocity, Vector3<double>(0.4848048562114556, -0.022616638311467097, -0.4375740810531299));
}

TEST(SceneJson, NamesTheFieldThatIsWrong) {
  ASSERT_EQ(error_of(small_scene()), "") << "else everything is refused";
  for (const tests::Refusal& refusal : tests::refusals()) {
    EXPECT_EQ(error_of(refusal.scene()), refusal.message);
  }
  EXPECT_EQ(error_of(json::array()), "/: expected an object, found []");
}

/// A defect of a body has no field, or a field that is a list. The ends of the messages depend on rounding.
TEST(SceneJson, NamesTheBodyThatIsWrong) {
  json flat = small_scene();
  flat["polyhedra"][0]["vertices"] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_TRUE(error_of(flat).starts_with("/polyhedra/0/vertices: all vertices lie in one plane")) << error_of(flat);
  json within = small_scene();
  within["polyhedra"][1]["position"] = within["polyhedra"][0]["position"];
  EXPECT_TRUE(
      error_of(within).starts_with("/polyhedra/1: polyhedron 1 (polyhedron 1) may overlap polyhedron 0 (box): -"))
      << error_of(within);
  json overlapping = small_scene();
  overlapping["lattices"][0]["spacing"][0] = 0.999;
  EXPECT_TRUE(error_of(overlapping).starts_with("/lattices/0: sphere 2 (row 1) overlaps sphere 1 (row 0)"))
      << error_of(overlapping);
}

TEST(SceneJson, MovesBodiesApartThatTouchWithinRounding) {
  json touching = small_scene();
  touching["lattices"][0]["spacing"][0] = 1;
  touching["polyhedra"] = json::array();
  EXPECT_EQ(scene_from_json(touching).moved_apart.bodies, 0U) << "spheres may touch";
  touching["lattices"][0]["spacing"][0] = 0.9999999999999999;
  EXPECT_EQ(scene_from_json(touching).moved_apart.bodies, 2U);
  touching["polyhedra"] = small_scene()["polyhedra"];
  touching["polyhedra"][1] = touching["polyhedra"][0];
  for (int k = 0; k < 2; ++k) {
    touching["polyhedra"][static_cast<std::size_t>(k)]["orientation"] = {1, 0, 0, 0};
    touching["polyhedra"][static_cast<std::size_t>(k)]["position"] = {2, -2.5, k == 0 ? 0.0 : 1.0};
  }
  const Scene scene = scene_from_json(touching);
  EXPECT_EQ(scene.moved_apart.bodies, 4U);
  EXPECT_GT(scene.polyhedra[0].position.z(), 0);
  EXPECT_GT(scene.polyhedra[1].position.z(), 1 + scene.polyhedra[0].position.z());
  EXPECT_LE(scene.moved_apart.farthest, 1e-12);
}

TEST(SceneJson, WritesPolyhedraAsTheyWereGiven) {
  json given = small_scene()["polyhedra"];
  given[1]["name"] = "polyhedron 1";
  given[1]["orientation"] = {1, 0, 0, 0};
  given[1]["velocity"] = given[1]["angular_velocity"] = {0, 0, 0};
  EXPECT_EQ(scene_to_json(scene_from_json(small_scene())).at("polyhedra"), given);
}

TEST(SceneJson, RequiresContactsOnlyForBodiesThatCanMeet) {
  json file = small_scene();
  file["materials"].push_back("unused");
  EXPECT_EQ(error_of(file), "");
  file.erase("contacts");
  EXPECT_EQ(error_of(file), "") << "all have the defaults";
  file["contacts"] = json::array();
  EXPECT_NE(error_of(file), "");
}

}  // namespace
}  // namespace carom::scene
