// SPDX-License-Identifier: BSL-1.0
#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/scene/json/scene_json.hpp>

#include "shipped.hpp"

namespace carom::scene {
namespace {

using nlohmann::json;
using tests::small_scene;
using tests::small_scene_with_polyhedra;

/// The reader's error; empty if there is none.
std::string error_of(const json& file) {
  try {
    (void)scene_from_json(file);
  } catch (const FormatError& error) {
    return error.what();
  }
  return {};
}

TEST(SceneJson, ReadsEveryField) {
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
  EXPECT_EQ(scene.spheres[3].position, Vector3<double>(1, 2, 4));
  const Vector3<double> sum = scene.spheres[1].velocity + scene.spheres[2].velocity + scene.spheres[3].velocity;
  EXPECT_LT(sum.norm(), 1e-15);
}

TEST(SceneJson, ReadsEveryFieldOfAPolyhedron) {
  const Scene scene = scene_from_json(small_scene_with_polyhedra());
  EXPECT_EQ(scene.spheres.size(), 4);
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

TEST(SceneJson, HasDefaults) {
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

TEST(SceneJson, RoundTrips) {
  std::vector<json> files{small_scene(), small_scene_with_polyhedra()};
  for (const auto& path : tests::shipped_scenes()) {
    files.push_back(tests::json_of(path));
  }
  EXPECT_EQ(files.size(), 9);
  for (const json& file : files) {
    const json written = scene_to_json(scene_from_json(file));
    EXPECT_EQ(scene_to_json(scene_from_json(parse_json(written.dump()))).dump(), written.dump()) << file.at("title");
    EXPECT_EQ(written.at("title"), file.at("title"));
    EXPECT_EQ(written.contains("polyhedra"), file.contains("polyhedra"));
  }
}

TEST(SceneJson, DrawsTheSameVelocitiesEverywhere) {
  json file = small_scene();
  file["lattices"][0]["at_rest_as_a_whole"] = false;
  const Scene scene = scene_from_json(file);
  // Another program computed this velocity from the seed 7.
  EXPECT_EQ(scene.spheres[1].velocity, Vector3<double>(0.4848048562114556, -0.022616638311467097, -0.4375740810531299));
}

TEST(SceneJson, DrawsWithTheDeviationAskedFor) {
  const Scene scene = scene_from_json(json::parse(
      R"({"duration": 1, "lattices": [{"count": [20, 20, 20], "first": [0, 0, 0], "spacing": [1, 1, 1], "radius": 0.5,
          "density": 1, "speed": 3}]})"));
  double sum = 0;
  double squares = 0;
  for (const Sphere& sphere : scene.spheres) {
    sum += sphere.velocity.sum();
    squares += sphere.velocity.squaredNorm();
  }
  EXPECT_NEAR(sum / 24000, 0, 0.08);
  EXPECT_NEAR(squares / 24000, 9, 0.35);
}

TEST(SceneJson, ReadsAHundredThousandSpheresInASecond) {
  const json lattice = json::parse(
      R"({"duration": 1, "lattices": [{"count": [50, 50, 40], "first": [0, 0, 0], "spacing": [1, 1, 1], "radius": 0.5,
          "density": 1, "speed": 1}]})");
  const json written = scene_to_json(scene_from_json(lattice));
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(scene_from_json(written).spheres.size(), 100'000);
  // Reading takes some tenths of a second, but tests run in parallel and without optimisation.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(SceneJson, SaysWhatIsWrongAndWhere) {
  using Change = std::function<void(json&)>;
  const std::vector<std::pair<std::string, Change>> changes{
      {"/duration: is missing; add this field", [](json& s) { s.erase("duration"); }},
      {"/duration: expected a finite number of at least 0, found -1", [](json& s) { s["duration"] = -1; }},
      {"/duration: expected a finite number, found \"inf\"", [](json& s) { s["duration"] = "inf"; }},
      {"/spheres/0/velocity/1: expected a finite number, found \"nan\"",
       [](json& s) { s["spheres"][0]["velocity"][1] = "nan"; }},
      {"/spheres/0/radius: expected a number greater than 0, found -1",
       [](json& s) { s["spheres"][0]["radius"] = -1; }},
      {"/spheres/0/position: expected an array of 3 numbers, found [1,2]",
       [](json& s) {
         s["spheres"][0]["position"] = {1, 2};
       }},
      {"/spheres/0/colour: unknown field; expected one of name, radius, density, material, position, velocity, "
       "angular_velocity",
       [](json& s) { s["spheres"][0]["colour"] = "red"; }},
      {"/spheres/0/material: is missing; name one of the 2 materials",
       [](json& s) { s["spheres"][0].erase("material"); }},
      {"/spheres/0/material: expected one of the materials \"steel\", \"wood\", found \"stone\"",
       [](json& s) { s["spheres"][0]["material"] = "stone"; }},
      {"/law: expected frictionless, reflection, sticking, rough or coulomb, found \"any\"",
       [](json& s) { s["law"] = "any"; }},
      {"/precision: expected binary32, binary64 or extended, found \"double\"",
       [](json& s) { s["precision"] = "double"; }},
      {"/gravity: expected gravity along one world axis, so that two of its three numbers are 0, found [1,0,-9.81]",
       [](json& s) { s["gravity"][0] = 1; }},
      {"/capture_height: expected a finite number greater than 0, found 0", [](json& s) { s["capture_height"] = 0; }},
      {"/materials/1: expected different names, found \"steel\" twice", [](json& s) { s["materials"][1] = "steel"; }},
      {"/contacts/1: expected each pair of materials once, but this repeats the pair of /contacts/0",
       [](json& s) {
         s["contacts"][1]["materials"] = {"wood", "steel"};
       }},
      {"/contacts/0/restitution: expected a number from 0 to 1, found 1.5",
       [](json& s) { s["contacts"][0]["restitution"] = 1.5; }},
      {"/contacts/0/tangential_restitution: expected a number from -1 to 1, found -2",
       [](json& s) { s["contacts"][0]["tangential_restitution"] = -2; }},
      {"/contacts/0/friction: expected a finite number of at least 0, found -0.1",
       [](json& s) { s["contacts"][0]["friction"] = -0.1; }},
      {"/contacts: expected an entry for the materials \"steel\" and \"wood\", of sphere 0 (sphere 0) and plane 0 "
       "(room "
       "-x)",
       [](json& s) { s["contacts"].erase(0); }},
      {"/contacts: expected an entry for the materials \"steel\" and \"steel\", of sphere 0 (sphere 0) and sphere 1 "
       "(row "
       "0)",
       [](json& s) { s["contacts"].erase(1); }},
      {"/planes/0/normal: expected a vector with a length that is not 0 and does not overflow binary64, found [0,0,0]",
       [](json& s) {
         s["planes"][0]["normal"] = {0, 0, 0};
       }},
      {"/room/greatest/2: expected a number greater than /room/least/2, found 0",
       [](json& s) { s["room"]["greatest"][2] = 0; }},
      {"/lattices/0/count: expected three integers of at least 1, found [3,0,1]",
       [](json& s) { s["lattices"][0]["count"][1] = 0; }},
      {"/lattices/0/count: expected at most 1000000 spheres in total",
       [](json& s) {
         s["lattices"][0]["count"] = {1'000'000, 1'000'000, 18446744073709551615U};
       }},
      {"/lattices/0/seed: expected an integer from 0 to 2^64 - 1, found 1.5",
       [](json& s) { s["lattices"][0]["seed"] = 1.5; }},
      {"/lattices/0/density: expected a number greater than 0, found 0",
       [](json& s) { s["lattices"][0]["density"] = 0; }},
      {"/lattices/0: sphere 2 (row 1) overlaps sphere 1 (row 0)",
       [](json& s) { s["lattices"][0]["spacing"][0] = 0x1.fffffffffffffp-1; }},
      {"/spheres/0: sphere 0 (sphere 0) overlaps plane 4 (room -z), or is behind it; move one of them",
       [](json& s) { s["spheres"][0]["position"][2] = 0.25; }},
      {"/spheres/0: expected radius and density that give a moment of inertia from 2.22507e-308 to 1.79769e+308, not 0",
       [](json& s) { s["spheres"][0]["radius"] = 1e-90; }},
      {"/spheres/0/position: expected a position within 2^28 diameters of the largest sphere from the origin, found "
       "[0.0,0.0,1e+200]",
       [](json& s) {
         s["spheres"][0]["position"] = {0.0, 0.0, 1e200};
       }},
      {"/polyhedra: expected an array, found 1", [](json& s) { s["polyhedra"] = 1; }},
  };
  ASSERT_EQ(error_of(small_scene()), "") << "else everything is refused";
  for (const auto& [expected, change] : changes) {
    json file = small_scene();
    change(file);
    EXPECT_EQ(error_of(file), expected);
  }
  EXPECT_EQ(error_of(json::array()), "/: expected an object, found []");
}

TEST(SceneJson, WritesPolyhedraAsTheyWereGiven) {
  json given = small_scene_with_polyhedra()["polyhedra"];
  given[1]["name"] = "polyhedron 1";
  given[1]["orientation"] = {1, 0, 0, 0};
  given[1]["velocity"] = given[1]["angular_velocity"] = {0, 0, 0};
  EXPECT_EQ(scene_to_json(scene_from_json(small_scene_with_polyhedra())).at("polyhedra"), given);
}

TEST(SceneJson, SaysWhatIsWrongWithAPolyhedronAndWhere) {
  using Change = std::function<void(json & first)>;
  const std::vector<std::pair<std::string, Change>> changes{
      {"/polyhedra/0: expected an object, found 1", [](json& p) { p = 1; }},
      {"/polyhedra/0/vertices: is missing; add this field", [](json& p) { p.erase("vertices"); }},
      {"/polyhedra/0/vertices: expected an array, found 7", [](json& p) { p["vertices"] = 7; }},
      {"/polyhedra/0/vertices: expected 4 to 100 points, found 3",
       [](json& p) { p["vertices"].erase(p["vertices"].begin() + 3, p["vertices"].end()); }},
      {"/polyhedra/0/vertices: expected 4 to 100 points, found 1001",
       [](json& p) {
         p["vertices"] = std::vector<json>(1001, {0, 0, 0});
       }},
      {"/polyhedra/0/vertices/2: expected an array of 3 numbers, found [0,1]",
       [](json& p) {
         p["vertices"][2] = {0, 1};
       }},
      {"/polyhedra/0/vertices/2/1: expected a finite number, found \"nan\"",
       [](json& p) { p["vertices"][2][1] = "nan"; }},
      {"/polyhedra/0/density: is missing; add this field", [](json& p) { p.erase("density"); }},
      {"/polyhedra/0/density: expected a number greater than 0, found 0", [](json& p) { p["density"] = 0; }},
      {"/polyhedra/0/density: expected a number greater than 0, found -1", [](json& p) { p["density"] = -1; }},
      {"/polyhedra/0/position: is missing; add this field", [](json& p) { p.erase("position"); }},
      {"/polyhedra/0/position: expected an array of 3 numbers, found [1,2]",
       [](json& p) {
         p["position"] = {1, 2};
       }},
      {"/polyhedra/0/orientation: expected an array of 4 numbers, found [1,0,0]",
       [](json& p) {
         p["orientation"] = {1, 0, 0};
       }},
      {"/polyhedra/0/orientation: expected four finite numbers w, x, y, z that are not all 0, found [0,0,0,0]",
       [](json& p) {
         p["orientation"] = {0, 0, 0, 0};
       }},
      {"/polyhedra/0/orientation/3: expected a finite number, found null",
       [](json& p) { p["orientation"][3] = nullptr; }},
      {"/polyhedra/0/velocity/0: expected a finite number, found \"inf\"", [](json& p) { p["velocity"][0] = "inf"; }},
      {"/polyhedra/0/angular_velocity: expected an array of 3 numbers, found 4",
       [](json& p) { p["angular_velocity"] = 4; }},
      {"/polyhedra/0/material: expected one of the materials \"steel\", \"wood\", found \"stone\"",
       [](json& p) { p["material"] = "stone"; }},
      {"/polyhedra/0/radius: unknown field; expected one of name, vertices, density, material, position, orientation, "
       "velocity, angular_velocity",
       [](json& p) { p["radius"] = 1; }},
      {"/polyhedra/0/name: expected a string, found 3", [](json& p) { p["name"] = 3; }},
  };
  ASSERT_EQ(error_of(small_scene_with_polyhedra()), "") << "else everything is refused";
  for (const auto& [expected, change] : changes) {
    json file = small_scene_with_polyhedra();
    change(file["polyhedra"][0]);
    EXPECT_EQ(error_of(file), expected);
  }
}

/// The test compares only the beginnings of messages, because the rest depends on rounding.
TEST(SceneJson, RefusesPolyhedraThatCannotBeThere) {
  using Change = std::function<void(json & scene)>;
  const std::vector<std::pair<std::string, Change>> changes{
      {"/polyhedra/0/vertices: all vertices lie in one plane",
       [](json& s) {
         s["polyhedra"][0]["vertices"] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
       }},
      {"/polyhedra/0/vertices: vertex 8 is not a corner: it lies inside the convex hull of the others, or on its "
       "boundary",
       [](json& s) {
         s["polyhedra"][0]["vertices"].push_back({0.5, 0.5, 0.5});
       }},
      {"/polyhedra/0/vertices: vertex 8 equals vertex 1",
       [](json& s) {
         s["polyhedra"][0]["vertices"].push_back({1, 0, 0});
       }},
      {"/polyhedra/1: expected a centre of mass within 4096 radii of the origin, found the distance 60000",
       [](json& s) {
         s["room"]["greatest"][2] = 1e6;
         s["polyhedra"][1]["position"][2] = 60000;
       }},
      {"/polyhedra/0: expected vertices and density that give mass and moments of inertia from 1.17549e-38 to "
       "3.40282e+38, not 1e+39",
       [](json& s) {
         s["precision"] = "binary32";
         s["polyhedra"][0]["density"] = 1e39;
       }},
      {"/polyhedra/0: polyhedron 0 (box) may overlap plane 4 (room -z): ",
       [](json& s) {
         s["polyhedra"][0]["orientation"] = {1, 0, 0, 0};
         s["polyhedra"][0]["position"][2] = 0;
       }},
      {"/polyhedra/1: polyhedron 1 (polyhedron 1) may overlap polyhedron 0 (box): -",
       [](json& s) { s["polyhedra"][1]["position"] = s["polyhedra"][0]["position"]; }},
      {"/polyhedra/1: polyhedron 1 (polyhedron 1) may overlap sphere 0 (sphere 0): -",
       [](json& s) { s["polyhedra"][1]["position"] = s["spheres"][0]["position"]; }},
      {"/lattices/0: sphere 2 (row 1) may overlap sphere 1 (row 0): 0 m is the computed gap",
       [](json& s) { s["lattices"][0]["spacing"][0] = 1; }},
      {"/polyhedra: expected at most 2000 bodies in a scene with polyhedra, found 2001",
       [](json& s) { s["polyhedra"] = std::vector<json>(1997, s["polyhedra"][0]); }},
      {"/contacts: expected an entry for the materials \"wood\" and \"wood\", of polyhedron 0 (box) and plane 0 (room "
       "-x)",
       [](json& s) { s["contacts"].erase(2); }},
  };
  for (const auto& [expected, change] : changes) {
    json file = small_scene_with_polyhedra();
    change(file);
    EXPECT_TRUE(error_of(file).starts_with(expected)) << error_of(file) << "\nexpected " << expected;
  }
}

TEST(SceneJson, AsksForContactsOnlyOfWhatCanMeet) {
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
