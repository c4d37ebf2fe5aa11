// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scene/replay_html.hpp"
#include "support/program.hpp"

namespace carom::tests::polyhedra {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string shipped(const std::string& name) {
  return std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes/" + name + ".json";
}

std::vector<std::string> split(const std::string& text, char mark) {
  std::vector<std::string> parts;
  std::string part;
  for (const char c : text) {
    if (c == mark) {
      parts.push_back(part);
      part.clear();
    } else {
      part += c;
    }
  }
  parts.push_back(part);
  return parts;
}

/// The sum of the energy changes by impacts, relative to the largest energy.
double work_of_impacts(const json& record) {
  const json& causes = record["ledger"]["causes"];
  return (causes["impacts of bodies"].get<double>() + causes["impacts with planes"].get<double>()) /
         record["ledger"]["scale"].get<double>();
}

TEST(SceneOfPolyhedra, WritesWhatItPromises) {
  const TemporaryDirectory directory;
  const fs::path out = directory.path() / "out";
  const RunResult result = run_carom({"scene", shipped("tumbling_polyhedra"), "--out", out.string()});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_NE(result.output.find("12 polyhedra, 0 spheres"), std::string::npos) << result.output;
  for (const char* name :
       {"events.csv", "series.csv", "scene.json", "report.html", "energy.svg", "momentum.svg", "spin.svg"}) {
    EXPECT_GT(fs::file_size(out / name), 0U) << name;
  }
  const json record = json::parse(content_of(out / "scene.json"));
  EXPECT_TRUE(record["holds"].get<bool>());
  EXPECT_EQ(record["polyhedra"], 12);
  EXPECT_EQ(record["validity"]["invalid"], 0);
  EXPECT_GT(record["validity"]["pairs"], 0);
  EXPECT_LE(record["validity"]["unseen"].get<double>(), 0x1p-30);
  EXPECT_EQ(record["impulses"]["judged"], record["impulses"]["all"]);

  // Each line has as many columns as the header. Orientations have length 1. Without a second body, the orientation of
  // B is empty.
  const std::vector<std::string> lines = split(content_of(out / "events.csv"), '\n');
  ASSERT_EQ(lines.size(), 2 + record["events"]["all"].get<std::size_t>());
  const std::vector<std::string> names = split(lines[0], ',');
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  const std::size_t of_a = column("a_orientation_w");
  const std::size_t of_b = column("b_orientation_w");
  ASSERT_EQ(of_b, of_a + 4);
  ASSERT_EQ(names.size(), of_b + 4);
  EXPECT_EQ(names.back(), "b_orientation_z");
  int with_planes = 0;
  for (std::size_t k = 1; k + 1 < lines.size(); ++k) {
    const std::vector<std::string> fields = split(lines[k], ',');
    ASSERT_EQ(fields.size(), names.size()) << lines[k];
    const auto length = [&](std::size_t first) {
      double squares = 0;
      for (std::size_t i = first; i < first + 4; ++i) {
        squares += std::stod(fields[i]) * std::stod(fields[i]);
      }
      return std::sqrt(squares);
    };
    EXPECT_NEAR(length(of_a), 1, 1e-14);
    if (fields[column("kind")] == "renewal") {
      EXPECT_EQ(fields[column("b")] + fields[column("plane")] + fields[of_b], "");
    } else if (fields[column("b")].empty()) {
      ++with_planes;
      EXPECT_EQ(fields[of_b], "");
      EXPECT_FALSE(fields[column("plane")].empty());
    } else {
      EXPECT_NEAR(length(of_b), 1, 1e-14);
    }
  }
  EXPECT_EQ(with_planes, record["events"]["plane_impacts"]);

  EXPECT_EQ(fs::exists(out / "replay.html"), tool::has_replay());
  if (tool::has_replay()) {
    const std::string page = content_of(out / "replay.html");
    const std::string mark = "id=\"replay\">";
    const std::size_t begin = page.find(mark) + mark.size();
    const json replay = json::parse(page.substr(begin, page.find("</script>", begin) - begin));
    ASSERT_EQ(replay["arcs"].size(), 12U);
    for (const json& arcs : replay["arcs"]) {
      double last = -1;
      for (const json& arc : arcs) {
        // Time, five vectors, the phase, and the orientation.
        ASSERT_EQ(arc.size(), 1 + 5 * 3 + 1 + 4U);
        EXPECT_EQ(arc[16], "flying");
        double squares = 0;
        for (std::size_t i = 17; i < 21; ++i) {
          squares += arc[i].get<double>() * arc[i].get<double>();
        }
        EXPECT_NEAR(squares, 1, 1e-13);
        EXPECT_GT(arc[0].get<double>(), last - 1e-15);
        last = arc[0].get<double>();
      }
    }
    EXPECT_EQ(replay["bodies"][1]["kind"], "polyhedron");
    EXPECT_EQ(replay["bodies"][1]["vertices"].size(), 4U);
    EXPECT_EQ(replay["bodies"][1]["faces"].size(), 4U);
  }
}

/// If N is no eigenvector of the collision matrix, `reflection` may create energy. `frictionless` conserves energy
/// here.
TEST(SceneOfPolyhedra, GainsEnergyUnderReflectionAlone) {
  const RunResult result =
      run_carom({"scene", shipped("tumbling_polyhedra"), "--laws", "frictionless,reflection", "--format", "json"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const json records = json::parse(result.output);
  // There are about 75 impacts, each with a rounding error of 2⁻⁵³.
  EXPECT_LE(std::abs(work_of_impacts(records[0])), 1e-14);
  EXPECT_GT(work_of_impacts(records[1]), 0.25);
  for (const json& record : records) {
    EXPECT_TRUE(record["holds"].get<bool>()) << record["law"];
    EXPECT_LE(record["ledger"]["relative_rounding"].get<double>(), 1e-12);
    const json& initial = record["ledger"]["initial"];
    const json& final = record["ledger"]["final"];
    double gained = 0;
    for (const char* part : {"translation", "rotation", "potential"}) {
      gained += final[part].get<double>() - initial[part].get<double>();
    }
    EXPECT_NEAR(gained / record["ledger"]["scale"].get<double>(), work_of_impacts(record), 1e-12) << record["law"];
  }
}

/// For spheres `reflection` equals `frictionless`.
TEST(SceneOfSpheres, NeverGainsEnergyUnderReflection) {
  for (const char* scene : {"bouncing_spheres", "spinning_floor", "break", "cradle"}) {
    const RunResult result = run_carom({"scene", shipped(scene), "--laws", "reflection", "--format", "json"});
    ASSERT_EQ(result.exit_status, 0) << scene << result.errors;
    const json parsed = json::parse(result.output);
    EXPECT_LE(work_of_impacts(parsed.is_array() ? parsed[0] : parsed), 1e-14) << scene;
  }
}

TEST(SceneOfPolyhedra, DiceHold) {
  const RunResult result = run_carom({"scene", shipped("dice"), "--events", "300", "--format", "json"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const json record = json::parse(result.output);
  EXPECT_TRUE(record["holds"].get<bool>());
  EXPECT_EQ(record["events"]["all"], 300);
  EXPECT_EQ(record["validity"]["invalid"], 0);
  EXPECT_LT(work_of_impacts(record), -0.01);
}

TEST(SceneOfPolyhedra, RefusesWithThePlace) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("scene.json", R"({"duration": 1, "polyhedra": [
      {"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "density": 1, "position": [0,0,0]},
      {"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "density": 1, "position": [0.125,0,0]}]})");
  const RunResult result = run_carom({"scene", file});
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_NE(result.errors.find("/polyhedra/1: polyhedron 1 (polyhedron 1) may overlap polyhedron 0 (polyhedron 0)"),
            std::string::npos)
      << result.errors;
}

TEST(PlanOfPolyhedra, NamesTheirClasses) {
  const RunResult result = run_carom({"plan", shipped("tumbling_polyhedra"), "--repetitions", "0"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_NE(result.output.find("\npolyhedra: wood and wood "), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("\npolyhedron and plane: wood and wood "), std::string::npos);
  EXPECT_NE(result.output.find("frictionless-"), std::string::npos);
  EXPECT_EQ(result.output.find("spheres: "), std::string::npos);
}

}  // namespace
}  // namespace carom::tests::polyhedra
