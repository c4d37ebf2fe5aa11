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
      {"materials": ["steel", "steel"]},
      {"materials": ["wood", "wood"], "restitution": 0.25}
    ],
    "room": {"least": [-4, -4, 0], "greatest": [4, 4, 8], "material": "wood"},
    "planes": [{"name": "ramp", "normal": [1, 0, 2], "point": [-4, 0, 0], "material": "wood"}],
    "spheres": [{"radius": 0.5, "density": 1000, "material": "steel", "position": [0, 0, 4], "velocity": [1, 2, 3]}],
    "lattices": [{"name": "row", "count": [3, 1, 1], "first": [-1, 2, 4], "spacing": [1.25, 0, 0], "radius": 0.5,
                  "density": 500, "material": "steel", "speed": 0.5, "seed": 7, "at_rest_as_a_whole": true}],
    "polyhedra": [
      {"name": "box", "density": 700, "material": "wood", "position": [2, -2.5, 2], "orientation": [0.1, -2, 0.3, 0.4],
       "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]],
       "velocity": [1, 2, 3], "angular_velocity": [4, 5, 6]},
      {"vertices": [[0.25, 0.25, 0.25], [0.25, -0.25, -0.25], [-0.25, 0.25, -0.25], [-0.25, -0.25, 0.25]],
       "density": 7800, "material": "steel", "position": [-1, -2, 6]}
    ]
  })");
}

/// A change that makes `small_scene` invalid, and the reader's message.
struct Refusal {
  std::string message;
  std::string place;              // of the change, a JSON pointer
  std::string value;              // the new JSON at this place; empty to remove the place
  bool is_beyond_schema = false;  // whether the schema accepts the scene, because it cannot state the condition

  [[nodiscard]] nlohmann::json scene() const {
    nlohmann::json changed = small_scene();
    if (value.empty()) {
      return changed.patch({{{"op", "remove"}, {"path", place}}});
    }
    changed[nlohmann::json::json_pointer(place)] = parse_json(value);
    return changed;
  }
};

/// A JSON list of `count` equal elements.
[[nodiscard]] inline std::string list_of(int count, const std::string& element) {
  std::string list = "[" + element;
  for (int k = 1; k < count; ++k) {
    list += "," + element;
  }
  return list + "]";
}

[[nodiscard]] inline std::vector<Refusal> refusals() {
  constexpr bool beyond_schema = true;
  return {
      {"/duration: is missing; add this field", "/duration", ""},
      {"/duration: expected a finite number of at least 0, found -1", "/duration", "-1"},
      {"/spheres/0/velocity/1: expected a finite number, found \"nan\"", "/spheres/0/velocity/1", R"("nan")"},
      {"/spheres/0/radius: expected a number greater than 0, found -1", "/spheres/0/radius", "-1"},
      {"/spheres/0/position: expected an array of 3 numbers, found [1,2]", "/spheres/0/position", "[1, 2]"},
      {"/spheres/0/colour: unknown field; expected one of name, radius, density, material, position, velocity, "
       "angular_velocity",
       "/spheres/0/colour", R"("red")"},
      {"/spheres/0/material: is missing; name one of the 2 materials", "/spheres/0/material", "", beyond_schema},
      {"/spheres/0/material: expected one of the materials \"steel\", \"wood\", found \"stone\"", "/spheres/0/material",
       R"("stone")", beyond_schema},
      {"/law: expected frictionless, reflection, sticking, rough or coulomb, found \"any\"", "/law", R"("any")"},
      {"/precision: expected binary32, binary64 or extended, found \"double\"", "/precision", R"("double")"},
      {"/gravity/0: expected a finite number, found \"down\"", "/gravity/0", R"("down")"},
      {"/capture_height: expected a finite number greater than 0, found 0", "/capture_height", "0"},
      {"/materials/1: expected different names, found \"steel\" twice", "/materials/1", R"("steel")"},
      {"/contacts/1: expected each pair of materials once, but this repeats the pair of /contacts/0",
       "/contacts/1/materials", R"(["wood", "steel"])", beyond_schema},
      {"/contacts/0/restitution: expected a number from 0 to 1, found 1.5", "/contacts/0/restitution", "1.5"},
      {"/contacts/0/tangential_restitution: expected a number from -1 to 1, found -2",
       "/contacts/0/tangential_restitution", "-2"},
      {"/contacts/0/friction: expected a finite number of at least 0, found -0.1", "/contacts/0/friction", "-0.1"},
      {"/contacts: expected an entry for the materials \"steel\" and \"wood\", of sphere 0 (sphere 0) and polyhedron 0 "
       "(box)",
       "/contacts/0", "", beyond_schema},
      {"/contacts: expected an entry for the materials \"steel\" and \"steel\", of sphere 0 (sphere 0) and sphere 1 "
       "(row 0)",
       "/contacts/1", "", beyond_schema},
      {"/planes/0/normal: expected a vector with a length that is not 0 and does not overflow binary64, found [0,0,0]",
       "/planes/0/normal", "[0, 0, 0]"},
      {"/room/greatest/2: expected a number greater than /room/least/2, found 0", "/room/greatest/2", "0",
       beyond_schema},
      {"/lattices/0/count: expected three integers of at least 1, found [3,0,1]", "/lattices/0/count/1", "0"},
      {"/lattices/0/count: expected at most 1000000 spheres in total", "/lattices/0/count",
       "[1000000, 1000000, 18446744073709551615]", beyond_schema},
      {"/lattices/0/seed: expected an integer from 0 to 2^64 - 1, found 1.5", "/lattices/0/seed", "1.5"},
      {"/lattices/0/density: expected a number greater than 0, found 0", "/lattices/0/density", "0"},
      {"/lattices/0: sphere 2 (row 1) overlaps sphere 1 (row 0)", "/lattices/0/spacing/0", "0.999999999999",
       beyond_schema},
      {"/spheres/0: sphere 0 (sphere 0) overlaps plane 4 (room -z), or is behind it; move one of them",
       "/spheres/0/position/2", "0.25", beyond_schema},
      {"/spheres/0: expected radius and density that give a moment of inertia from 2.22507e-308 to 1.79769e+308, not 0",
       "/spheres/0/radius", "1e-90", beyond_schema},
      {"/spheres/0/position: expected a position within 2^28 diameters of the largest sphere from the origin, found "
       "[0.0,0.0,1e+200]",
       "/spheres/0/position", "[0.0, 0.0, 1e200]", beyond_schema},
      {"/spheres/0/velocity: expected a motion of at most 2^100 m within the duration, with an energy of at most "
       "2^1000 J, found [8e+307,2,3]",
       "/spheres/0/velocity/0", "8e307", beyond_schema},
      {"/polyhedra/0/velocity: expected a motion of at most 2^100 m within the duration, with an energy of at most "
       "2^1000 J, found [8e+307,2,3]",
       "/polyhedra/0/velocity/0", "8e307", beyond_schema},
      {"/polyhedra: expected an array, found 1", "/polyhedra", "1"},
      {"/polyhedra/0: expected an object, found 1", "/polyhedra/0", "1"},
      {"/polyhedra/0/vertices: is missing; add this field", "/polyhedra/0/vertices", ""},
      {"/polyhedra/0/vertices: expected 4 to 100 points, found 3", "/polyhedra/0/vertices",
       R"([[0, 0, 0], [1, 0, 0], [0, 1, 0]])"},
      {"/polyhedra/0/vertices: expected 4 to 100 points, found 1001", "/polyhedra/0/vertices",
       list_of(1001, "[0, 0, 0]")},
      {"/polyhedra/0/vertices/2: expected an array of 3 numbers, found [0,1]", "/polyhedra/0/vertices/2", "[0, 1]"},
      {"/polyhedra/0/vertices/2/1: expected a finite number, found \"nan\"", "/polyhedra/0/vertices/2/1", R"("nan")"},
      {"/polyhedra/0/density: is missing; add this field", "/polyhedra/0/density", ""},
      {"/polyhedra/0/density: expected a number greater than 0, found 0", "/polyhedra/0/density", "0"},
      {"/polyhedra/0/position: is missing; add this field", "/polyhedra/0/position", ""},
      {"/polyhedra/0/orientation: expected an array of 4 numbers, found [1,0,0]", "/polyhedra/0/orientation",
       "[1, 0, 0]"},
      {"/polyhedra/0/orientation: expected four finite numbers w, x, y, z that are not all 0, found [0,0,0,0]",
       "/polyhedra/0/orientation", "[0, 0, 0, 0]"},
      {"/polyhedra/0/orientation/3: expected a finite number, found null", "/polyhedra/0/orientation/3", "null"},
      {"/polyhedra/0/velocity/0: expected a finite number, found \"inf\"", "/polyhedra/0/velocity/0", R"("inf")"},
      {"/polyhedra/0/radius: unknown field; expected one of name, vertices, density, material, position, orientation, "
       "velocity, angular_velocity",
       "/polyhedra/0/radius", "1"},
      {"/polyhedra/0/name: expected a string, found 3", "/polyhedra/0/name", "3"},
      {"/polyhedra: expected at most 2000 bodies in a scene with polyhedra, found 2001", "/polyhedra",
       list_of(1997, small_scene()["polyhedra"][0].dump()), beyond_schema},
      {"/contacts: expected an entry for the materials \"wood\" and \"wood\", of polyhedron 0 (box) and plane 0 (room "
       "-x)",
       "/contacts/2", "", beyond_schema},
  };
}

}  // namespace carom::tests
