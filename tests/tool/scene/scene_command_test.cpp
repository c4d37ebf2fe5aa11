// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/oracles/laws/judge_error.hpp>

#include "scene/replay_html.hpp"
#include "scene/scene_records.hpp"
#include "scene/scene_run.hpp"
#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

json replay(const std::string& name = "cue") {
  return {{"title", name},
          {"law", "rough"},
          {"duration", 0.1 + 0.2},
          {"gravity", {0, 0, -9.81}},
          {"bodies", {{{"name", name}, {"kind", "sphere"}, {"radius", 0.03}}}},
          {"planes", {{{"name", name}, {"normal", {0, 0, 1}}, {"point", {0, 0, 0}}}}},
          {"room", nullptr},
          {"arcs", {{{0, 0, 0, 5e-324, 0, 0, 1.0 / 3, 0, 0, -9.81, 0, 0, 1e308, 0, 0, 0, "flying"}}}},
          {"impacts", json::array()},
          {"series", {{"t", {0}}, {"kinetic", {0}}, {"potential", {0}}, {"lost", {0}}, {"spin", {0}}}}};
}

std::size_t count(std::string_view text, std::string_view what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + what.size())) {
    ++found;
  }
  return found;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin) + begin.size();
  return text.substr(at, text.find(end, at) - at);
}

json embedded(const std::string& page) {
  return json::parse(between(page, "<script type=\"application/json\" id=\"replay\">", "</script>"));
}

class ReplayHtml : public testing::Test {
  void SetUp() override {
    if (!tool::has_replay()) {
      GTEST_SKIP() << "built without replays";
    }
  }
};

TEST(ReplayHtmlWithoutItsPage, SaysThatReplaysAreNotBuilt) {
  if (tool::has_replay()) {
    GTEST_SKIP() << "built with replays";
  }
  EXPECT_THROW(static_cast<void>(tool::replay_html("title", replay())), std::logic_error);
}

TEST_F(ReplayHtml, IsOnePageWithTheReplayTheTitleAndTheNoticeOfThreeJs) {
  const std::string page = tool::replay_html("Balls & walls", replay());
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_EQ(between(page, "<title>", "</title>"), "Balls &amp; walls");
  EXPECT_EQ(page.find("{{"), std::string::npos) << "a mark that nothing stands for";
  EXPECT_EQ(embedded(page), replay()) << "every digit is kept";
  unit::expect_in(page, {"Three.js Authors", "SPDX-License-Identifier: MIT"});
}

TEST_F(ReplayHtml, EscapesEachName) {
  const std::string harmless = tool::replay_html("title", replay());
  for (const std::string nasty : {"</script><script>alert(1)</script>", "<!--", "<!-- <script>", "</SCRIPT >",
                                  "</title><img src=x onerror=alert(1)>", "]]>", "\\u003c/script>", "{{replay}}",
                                  "{{title}}", "\xe2\x80\xa8 \"quoted\" \\ \n \x01"}) {
    const std::string page = tool::replay_html(nasty, replay(nasty));
    // In HTML, only the character `<` begins elements and comments.
    EXPECT_EQ(count(page, "<"), count(harmless, "<")) << nasty;
    EXPECT_EQ(embedded(page), replay(nasty)) << nasty;
  }
}

TEST_F(ReplayHtml, AcceptsNamesThatAreNotUtf8) {
  const std::string page = tool::replay_html("a\xff", replay("b\xff"));
  EXPECT_EQ(between(page, "<title>", "</title>"), "a\xef\xbf\xbd");
  EXPECT_EQ(embedded(page).at("title"), "b\xef\xbf\xbd");
}

TEST_F(ReplayHtml, LoadsNothingAndRunsWhatItContainsAlone) {
  const std::string page = tool::replay_html("title", replay());
  const std::string policy = between(page, "http-equiv=\"Content-Security-Policy\" content=\"", "\"");
  EXPECT_TRUE(policy.starts_with("default-src 'none'; script-src 'sha256-")) << policy;
  for (const char* permitted : {"unsafe", "http", "*", "data:", "blob:", "self"}) {
    EXPECT_EQ(policy.find(permitted), std::string::npos) << policy;
  }
  // The page's own elements, without the content of the script.
  const std::string markup = page.substr(0, page.rfind("<script>"));
  for (const char* loading : {" src=", " href=", " style=", " onload=", "url(", "@import"}) {
    EXPECT_EQ(markup.find(loading), std::string::npos) << loading;
  }
  EXPECT_EQ(count(markup, "<link"), 0U);
  EXPECT_EQ(count(page, "</script>"), 2U);
}

namespace fs = std::filesystem;

std::string shipped(const std::string& name) {
  return std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes/" + name + ".json";
}

json record_of(const std::string& name, const std::vector<std::string>& more = {}, int status = 0) {
  const RunResult result = run_carom({"scene", shipped(name), "--format", "json"}, more);
  EXPECT_EQ(result.exit_status, status) << result.errors;
  return json::parse(result.output);
}

std::vector<std::string> split(const std::string& text, char mark) {
  std::vector<std::string> parts;
  std::istringstream stream(text + mark);
  for (std::string part; std::getline(stream, part, mark);) {
    parts.push_back(part);
  }
  return parts;
}

/// The sum of the energy changes by impacts, relative to the largest energy.
double work_of_impacts(const json& record) {
  const json& causes = record["ledger"]["causes"];
  return (causes["impacts of bodies"].get<double>() + causes["impacts with planes"].get<double>()) /
         record["ledger"]["scale"].get<double>();
}

class ShippedScene : public testing::TestWithParam<std::string> {};

TEST_P(ShippedScene, IsValidItsImpulsesPassAndItsLedgerCloses) {
  const json record = record_of(GetParam());
  EXPECT_TRUE(record["holds"].get<bool>());
  EXPECT_EQ(record["simulated"], record["duration"]);
  EXPECT_EQ(record["validity"]["invalid"], 0);
  EXPECT_GT(record["validity"]["pairs"], 0);
  EXPECT_GT(record["impulses"]["judged"], 0);
  EXPECT_EQ(record["impulses"]["judged"], record["impulses"]["all"]);
  EXPECT_LE(record["ledger"]["relative_rounding"].get<double>(), record["ledger"]["rounding_limit"].get<double>());
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene,
                         testing::Values("bouncing_spheres", "spinning_floor", "break", "cradle", "tumbling_polyhedra",
                                         "dice"),
                         [](const auto& scene) { return scene.param; });

TEST(SceneCommand, GasKeepsItsEnergy) {
  const json record = record_of("gas", {"--events", "20000", "--judge-every", "20"}, 2);
  EXPECT_FALSE(record["holds"].get<bool>()) << "it ended early";
  EXPECT_FALSE(record["violated"].get<bool>());
  EXPECT_EQ(record["events"]["all"], 20000);
  EXPECT_LT(record["ledger"]["relative_rounding"].get<double>(), 1e-14);
  EXPECT_EQ(record["impulses"]["judged"], 1000);
  EXPECT_EQ(record["spins_changed"], 0);
}

TEST(SceneCommand, SpheresSpinUnderRoughAndNeverWithoutFrictionHoweverManyLawsRunAtOnce) {
  const auto records_of = [](const std::string& jobs) {
    json records = record_of("bouncing_spheres", {"--laws", "frictionless,reflection,rough", "--jobs", jobs});
    for (json& record : records) {
      record.erase("seconds");
    }
    return records;
  };
  const json records = records_of("1");
  EXPECT_EQ(records_of("3"), records);
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(records[0]["spins_changed"], 0);
  EXPECT_EQ(records[1]["spins_changed"], 0);
  EXPECT_EQ(records[2]["spins_changed"], 64);
  // For spheres `reflection` equals `frictionless`, bit for bit.
  EXPECT_EQ(records[0]["events"], records[1]["events"]);
  EXPECT_EQ(records[0]["ledger"], records[1]["ledger"]);
  EXPECT_LE(work_of_impacts(records[1]), 1e-14);
}

TEST(SceneCommand, WritesTheFilesOfASceneOfPolyhedra) {
  const TemporaryDirectory directory;
  const fs::path out = directory.path() / "out";
  const RunResult result = run_carom({"scene", shipped("tumbling_polyhedra"), "--out", out.string()});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  unit::expect_in(result.output, {"12 polyhedra, 0 spheres"});
  for (const char* name :
       {"events.csv", "series.csv", "scene.json", "report.html", "energy.svg", "momentum.svg", "spin.svg"}) {
    EXPECT_GT(fs::file_size(out / name), 0U) << name;
  }
  for (const auto& [name, unit] : {std::pair{"energy.svg", "energy [J]"}, std::pair{"momentum.svg", "momentum [N s]"},
                                   std::pair{"spin.svg", "[rad/s]"}}) {
    unit::expect_in(content_of(out / name), {unit});
  }
  unit::expect_in(content_of(out / "report.html"), {"the ledger closes"});
  const json record = json::parse(content_of(out / "scene.json"));
  EXPECT_EQ(record["polyhedra"], 12);
  EXPECT_LE(record["validity"]["unseen"].get<double>(), 0x1p-30);

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
    const json replay = embedded(content_of(out / "replay.html"));
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
TEST(SceneCommand, PolyhedraGainEnergyUnderReflectionAlone) {
  const json records = record_of("tumbling_polyhedra", {"--laws", "frictionless,reflection"});
  // There are about 75 impacts, each with a rounding error of 2⁻⁵³.
  EXPECT_LE(std::abs(work_of_impacts(records[0])), 1e-14);
  EXPECT_GT(work_of_impacts(records[1]), 0.25);
  for (const json& record : records) {
    EXPECT_TRUE(record["holds"].get<bool>()) << record["law"];
    const json& initial = record["ledger"]["initial"];
    const json& final = record["ledger"]["final"];
    double gained = 0;
    for (const char* part : {"translation", "rotation", "potential"}) {
      gained += final[part].get<double>() - initial[part].get<double>();
    }
    EXPECT_NEAR(gained / record["ledger"]["scale"].get<double>(), work_of_impacts(record), 1e-12) << record["law"];
  }
}

/// A replay that cannot hold all events ends just before the first event that does not fit. The output reports this.
TEST(SceneRun, ReplaysTheEventsThatFitIntoThePage) {
  const auto replayed = [](std::uint64_t most) {
    tool::SceneOptions options;
    options.most_replayed = most;
    const auto run = std::make_unique<tool::SceneRun>(
        tool::scene_of(content_of(shipped("spinning_floor")), "spinning_floor"), options);
    run->run();
    EXPECT_EQ(run->is_replay_cut(), most < 56);
    EXPECT_EQ(tool::scene_text(*run).find("replay    of the first 20 events") != std::string::npos, most == 20);
    return tool::replay_record(*run);
  };
  const json whole = replayed(56);
  EXPECT_EQ(whole["duration"], 12);
  EXPECT_FALSE(whole.contains("of_duration"));
  const json cut = replayed(20);
  EXPECT_EQ(cut["of_duration"], 12);
  EXPECT_LT(cut["duration"], 12);
  std::size_t arcs = 0;
  double latest = 0;
  for (const json& of_body : cut["arcs"]) {
    arcs += of_body.size();
    latest = std::max(latest, of_body.back()[0].get<double>());
  }
  EXPECT_EQ(arcs, 9U + 20U);
  EXPECT_LE(latest, cut["duration"]);
  EXPECT_LE(cut["series"]["t"].back(), cut["duration"]);
  EXPECT_GT(cut["series"]["t"].size(), 1U);
}

/// The callback throws in place of the judge.
TEST(SceneRun, KeepsItsResultsIfTheJudgeFails) {
  tool::SceneOptions options;
  std::size_t events = 0;
  options.on_event = [&](const scene::Event& event) {
    if (++events == 20) {
      throw oracles::JudgeError("a wrong formula", event.collision);
    }
  };
  const auto run = std::make_unique<tool::SceneRun>(
      tool::scene_of(content_of(shipped("spinning_floor")), "spinning_floor"), options);
  run->run();
  EXPECT_EQ(run->verdict(), tool::SceneVerdict::not_run_to_its_end);
  EXPECT_EQ(run->simulation().counts().events, 20U);
  EXPECT_GT(run->judge().judged(), 0U);
  EXPECT_GT(run->samples().size(), 1U);
  const std::string text = tool::scene_text(*run);
  unit::expect_in(text, {"NOT RUN TO ITS END; until ", "a wrong formula\n  A: "});
  EXPECT_EQ(tool::scene_record(*run)["ended_early"], run->ended_early());
}

TEST(SceneCommand, CutsEventsCsvAndNeverHoldsIfItEndsEarly) {
  const TemporaryDirectory directory;
  const std::string out = (directory.path() / "out").string();
  const RunResult result =
      run_carom({"scene", shipped("spinning_floor"), "--events", "30", "--csv-lines", "5", "--out", out});
  EXPECT_EQ(result.exit_status, 2);
  unit::expect_in(result.output, {"ended early: the limit of --events", "events.csv has the first 5 events",
                                  "\nNOT RUN TO ITS END; until ", " s of 12 s: nothing overlaps, "});
  EXPECT_EQ(result.output.find("holds"), std::string::npos);
  unit::expect_in(result.errors, {"the simulation stopped before the end of the scene"});
  EXPECT_EQ(count(content_of(fs::path(out) / "events.csv"), "\n"), 6U);
  EXPECT_EQ(json::parse(content_of(fs::path(out) / "scene.json"))["events"]["lines"], 5);
}

/// A scene of two balls of 0.1 m.
std::string two_balls(const std::string& first, const std::string& second, const std::string& more) {
  const std::string ball = R"({"radius": 0.1, "density": 1000, )";
  return R"({"duration": 3, "gravity": [0, 0, -9.81], "contacts": [{"materials": ["default", "default"],
             "restitution": 0.5}], "materials": ["default"], )" +
         more + R"("spheres": [)" + ball + first + "}, " + ball + second + "}]}";
}

const std::string on_a_floor = R"("planes": [{"name": "floor", "normal": [0, 0, 1], "point": [0, 0, 0]}], )";

TEST(SceneCommand, SaysWhichBodiesWouldHaveToRestAndWhatIsCertifiedUntilThen) {
  const TemporaryDirectory directory;
  const RunResult result = run_carom(
      {"scene", directory.write("pile.json", two_balls(R"("name": "low", "position": [0, 0, 0.1])",
                                                       R"("name": "high", "position": [0, 0, 0.5])", on_a_floor))});
  EXPECT_EQ(result.exit_status, 2);
  unit::expect_in(result.output,
                  {"ended early: at t = ", " s sphere 0 (low) and sphere 1 (high) would have to rest on each other",
                   "\nNOT RUN TO ITS END; until ", "nothing overlaps, ", "impulses pass, the ledger closes"});
}

TEST(SceneCommand, DoesNotCertifyEnergyThatTheRunAdds) {
  const TemporaryDirectory directory;
  // The balls fall together, and approach at 1 mm/s. With this capture height, they part at 4 mm/s.
  const RunResult result = run_carom(
      {"scene", directory.write("pair.json", two_balls(R"("position": [0, 0, 0])",
                                                       R"("position": [0.2001, 0, 0], "velocity": [-0.001, 0, 0])",
                                                       R"("capture_height": 10, )"))});
  EXPECT_EQ(result.exit_status, 2);
  unit::expect_in(result.output,
                  {"\nNOT CERTIFIED: nothing overlaps, 1 impulses pass, the ledger closes, slow contacts "
                   "added ",
                   " of the first energy (at most 1e-06)"});
  EXPECT_EQ(result.output.find("holds"), std::string::npos);
}

TEST(SceneCommand, SaysThatItMovedBodiesThatTouchInDecimals) {
  const TemporaryDirectory directory;
  const RunResult result =
      run_carom({"scene", directory.write("touch.json", two_balls(R"("position": [0.1, 0, 0.1])",
                                                                  R"("position": [0.3, 0, 0.1])", on_a_floor))});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  unit::expect_in(result.output, {"\nmoved     1 body by at most ", " m before the start, because of overlaps"});
}

TEST(SceneCommand, ShowsItsProgressOnATerminalAndHearsASignal) {
  // `script` gives the program a terminal. The run would take a minute.
  const RunResult result = run_program(
      "/usr/bin/script",
      {"-qec", "timeout -s TERM 5 " + carom_program() + " scene " + shipped("gas") + " | cat", "/dev/null"});
  unit::expect_in(result.output, {" s of 35 s, ", " events", "ended early: interrupted", "NOT RUN TO ITS END; until ",
                                  "the simulation stopped before the end"});
}

TEST(SceneCommand, PlansTheScalarSolverForPairsOfSpheres) {
  const RunResult result =
      run_carom({"plan", shipped("bouncing_spheres"), "--law", "reflection", "--repetitions", "0"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  unit::expect_in(result.output, {"spheres: ", "N is an eigenvector of K", "frictionless-"});
  EXPECT_EQ(result.output.find("normal_length"), std::string::npos);
}

TEST(SceneCommand, PlansForPolyhedraByTheirClasses) {
  const RunResult result = run_carom({"plan", shipped("tumbling_polyhedra"), "--repetitions", "0"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  unit::expect_in(result.output,
                  {"\npolyhedra: wood and wood ", "\npolyhedron and plane: wood and wood ", "frictionless-"});
  EXPECT_EQ(result.output.find("spheres: "), std::string::npos);
}

}  // namespace
}  // namespace carom::tests
