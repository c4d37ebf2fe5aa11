// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/cases.hpp"
#include "support/program.hpp"

/// The examples of docs/guide/plug-in.md are sound, and the gate finds defects planted in them.
namespace carom::tests {
namespace {

using nlohmann::json;

const std::filesystem::path documents = std::filesystem::path(CAROM_SOURCE_DIR) / "docs";

json report_on(const std::string& subject, int cases) {
  const TemporaryDirectory out;
  const RunResult run = run_carom({"gate", subject, "--cases", std::to_string(cases), "--out", out.path().string()});
  const std::string text = content_of(out.path() / "report.json");
  return text.empty() ? json{{"errors", run.errors}} : json::parse(text).at("subjects").at(0);
}

/// The first block of this language, without its fences; empty if the page has none.
std::string block_of(const std::string& page, const std::string& language) {
  const std::string fence = "\n```" + language + "\n";
  const std::size_t begin = page.find(fence);
  if (begin == std::string::npos) {
    return "";
  }
  const std::size_t first = begin + fence.size();
  return page.substr(first, page.find("\n```\n", first) + 1 - first);
}

TEST(Examples, AreLinkedInTheGuideAndQuotedWordForWord) {
  const std::string guide = content_of(documents / "guide" / "plug-in.md");
  const std::map<std::string, std::string> languages{
      {"solver.py", "python"}, {"solver.mjs", ""}, {"solver.cpp", "cpp"}, {"solver.c", ""}, {"reflection.py", ""}};
  for (const auto& [name, language] : languages) {
    EXPECT_NE(guide.find("(../examples/" + name + ")"), std::string::npos) << name << " is not linked";
    if (!language.empty()) {
      const std::string block = block_of(guide, language);
      ASSERT_FALSE(block.empty()) << name;
      EXPECT_NE(content_of(documents / "examples" / name).find(block), std::string::npos)
          << name << " differs from what docs/guide/plug-in.md shows";
    }
  }
}

TEST(Examples, InCppIsSound) {
  const json report = report_on(std::string("exec:") + CAROM_EXAMPLE_SOLVER, unit::effort(200));
  EXPECT_EQ(report.at("status"), "sound") << report;
  EXPECT_EQ(report.at("name"), "example-cpp");
}

TEST(Examples, InPythonIsSound) {
  const json report = report_on("exec:python3 " + (documents / "examples" / "solver.py").string(), unit::effort(200));
  EXPECT_EQ(report.at("status"), "sound") << report;
}

TEST(Examples, InJavaScriptIsSound) {
  const json report = report_on("exec:node " + (documents / "examples" / "solver.mjs").string(), unit::effort(200));
  EXPECT_EQ(report.at("status"), "sound") << report;
}

/// Hexadecimal numbers in place of JSON.
TEST(Examples, InCIsSound) {
  const TemporaryDirectory directory;
  const std::string program = (directory.path() / "my-solver").string();
  const RunResult built =
      run_program("/usr/bin/env", {"cc", "-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O2", "-o", program,
                                   (documents / "examples" / "solver.c").string(), "-lm"});
  ASSERT_EQ(built.exit_status, 0) << built.errors;
  const json report = report_on("exec:" + program, unit::effort(200));
  EXPECT_EQ(report.at("status"), "sound") << report;
  EXPECT_EQ(report.at("name"), "example-c");
}

TEST(Examples, OfReflectionIsSound) {
  const json report =
      report_on("exec:python3 " + (documents / "examples" / "reflection.py").string(), unit::effort(200));
  EXPECT_EQ(report.at("status"), "sound") << report;
  EXPECT_EQ(report.at("shows_collision_matrix"), true);
  for (const char* invariant : {"definite", "well_conditioned", "matrix_used"}) {
    std::uint64_t held = 0;
    for (const json& family : report.at("families")) {
      // A family of invalid collisions does not list this invariant.
      const json& invariants = family.at("invariants");
      held += invariants.contains(invariant) ? invariants.at(invariant).at("holds").get<std::uint64_t>() : 0;
    }
    EXPECT_GT(held, static_cast<unsigned>(unit::effort(100))) << invariant;
  }
}

/// The example in Python, which skips collisions outside of the plane z = 0. `more` goes into its reply to `start`.
std::string planar_solver(const std::string& more) {
  std::string text = content_of(documents / "examples" / "solver.py");
  const auto put_before = [&](const std::string& line, const std::string& added) {
    const std::size_t at = text.find(line);
    EXPECT_NE(at, std::string::npos) << line;
    text.insert(at, added);
  };
  put_before("    a, b = solve(request",
             "    c = request[\"collision\"]\n"
             "    bodies = [c[\"a\"], c[\"b\"]]\n"
             "    across = [c[\"point\"][2], c[\"normal\"][2]] + [x for b in bodies for x in [b[\"position\"][2],\n"
             "        b[\"velocity\"][2], *b[\"angular_velocity\"][:2], *b.get(\"orientation\", [1, 0, 0, 0])[1:3]]]\n"
             "    if any(map(float, across)):\n"
             "        return {\"id\": request[\"id\"], \"skipped\": \"not planar\"}\n");
  put_before("\"model\": ", more);
  return text;
}

TEST(Examples, OfAPlaneAreToldTheKindInWhichTheyAreSound) {
  const TemporaryDirectory directory;
  const std::string solver = "exec:python3 " + directory.write("planar.py", planar_solver(""));
  const RunResult everywhere = run_carom({"gate", solver, "--cases", "60"});
  EXPECT_EQ(everywhere.exit_status, 2) << everywhere.output;
  EXPECT_NE(everywhere.output.find("contacts in the plane z = 0: add --within plane=xy"), std::string::npos)
      << everywhere.output;
  const RunResult within = run_carom({"gate", solver, "--cases", "60", "--within", "plane=xy"});
  EXPECT_EQ(within.exit_status, 0) << within.output;
  const std::string declaring = planar_solver("\"domain\": {\"plane\": \"xy\"}, ");
  EXPECT_EQ(report_on("exec:python3 " + directory.write("planar.py", declaring), 60).at("status"), "sound");
}

struct Defect {
  std::string name;
  std::string line;
  std::string planted;
  std::string invariant;
  std::string example = "solver.py";
};

std::ostream& operator<<(std::ostream& out, const Defect& defect) { return out << defect.name; }

class Defects : public testing::TestWithParam<Defect> {};

TEST_P(Defects, AreFoundInTheExample) {
  std::string text = content_of(documents / "examples" / GetParam().example);
  const std::size_t at = text.find(GetParam().line);
  ASSERT_NE(at, std::string::npos) << GetParam().line;
  text.replace(at, GetParam().line.size(), GetParam().planted);
  const TemporaryDirectory directory;
  const json report = report_on("exec:python3 " + directory.write("solver.py", text), 20);
  EXPECT_EQ(report.at("status"), "violated") << report.dump(1);
  std::vector<std::string> violated;
  for (const json& violation : report.at("violations")) {
    violated.push_back(violation.at("invariant"));
  }
  EXPECT_NE(std::find(violated.begin(), violated.end(), GetParam().invariant), violated.end())
      << GetParam().invariant << " is not among " << json(violated);
}

const std::string impulse_line = "impulse = -(1 + record[\"restitution\"]) * approach / denominator";
const std::string velocity_line =
    "body.velocity = [v + sign * impulse / body.mass * n for v, n in zip(body.velocity, normal)]";
const std::string spin_line = "body.spin = [w + sign * impulse * r for w, r in zip(body.spin, turning[body][0])]";
const std::string at_contact_line = "zip(self.velocity, cross(self.spin, self.lever_arm))]";
const std::string denominator_term = "1 / body.mass + turning[body][1]";

std::string name_of(const testing::TestParamInfo<Defect>& each) { return each.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Some, Defects,
    testing::Values(Defect{"reaction_with_the_wrong_sign", velocity_line,
                           "body.velocity = [v + impulse / body.mass * n for v, n in zip(body.velocity, normal)]",
                           "linear_momentum"},
                    Defect{"spin_left_alone", spin_line, "pass", "angular_momentum"},
                    Defect{"matrix_of_one_body_shown", "    return a, b, k\n",
                           "    return a, b, collision_matrix([a])\n", "matrix_used", "reflection.py"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Each, Defects,
    testing::Values(
        Defect{"separating_contact_pulled", "if approach < 0 and movable:", "if movable:", "separating_untouched"},
        Defect{"normal_of_any_length_trusted", "normal = unit(vector(record[\"normal\"]))",
               "normal = vector(record[\"normal\"])", "restitution"},
        Defect{"quaternion_trusted", "w, x, y, z = unit(quaternion)", "w, x, y, z = quaternion", "angular_momentum"},
        Defect{"angular_term_twice", denominator_term, "1 / body.mass + 2 * turning[body][1]", "restitution"},
        Defect{"wrong_mass_in_the_reaction", velocity_line,
               "body.velocity = [v + sign * impulse / movable[0][0].mass * n for v, n in zip(body.velocity, normal)]",
               "linear_momentum"},
        Defect{"a_velocity_left_out", "zip(a.velocity_at_contact(), b.velocity_at_contact())",
               "zip(a.velocity_at_contact(), b.velocity)", "restitution"},
        Defect{"restitution_times_speed_twice", impulse_line,
               "impulse = -(1 + record[\"restitution\"] * abs(approach)) * approach / denominator", "homogeneous"},
        Defect{"no_rebound_below_a_threshold", impulse_line,
               "impulse = -(1 + (record[\"restitution\"] if approach < -1e-3 else 0)) * approach / denominator",
               "restitution"},
        Defect{"restitution_above_one_accepted", "if not 0 <= float(record[\"restitution\"]) <= 1:",
               "if not math.isfinite(float(record[\"restitution\"])):", "invalid_refused"},
        Defect{"inertia_in_the_body_frame", "axes = rotation(self.orientation)",
               "axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]", "angular_momentum"},
        Defect{"spin_crossed_the_wrong_way", at_contact_line, "zip(self.velocity, cross(self.lever_arm, self.spin))]",
               "restitution"},
        Defect{"spheres_made_to_spin", spin_line,
               "body.spin = [w + sign * impulse * (r + 1e-9 / body.mass) for w, r in zip(body.spin, turning[body][0])]",
               "collinear_spin"},
        Defect{"heavy_bodies_taken_as_fixed",
               "movable = [(body, sign) for body, sign in ((a, 1), (b, -1)) if not body.immovable]",
               "movable = [(body, sign) for body, sign in ((a, 1), (b, -1)) if not body.immovable and body.mass < 1e9]",
               "restitution"},
        Defect{"immovable_bodies_stopped", "return {\"velocity\": body.velocity,",
               "return {\"velocity\": [0.0, 0.0, 0.0] if body.immovable else body.velocity,", "immovable_untouched"},
        Defect{"outcome_in_single_precision", "return {\"velocity\": body.velocity, \"angular_velocity\": body.spin}",
               "import struct; single = lambda v: [struct.unpack('f', struct.pack('f', max(-3e38, min(3e38, x))))[0] "
               "for x in v]\n"
               "    return {\"velocity\": single(body.velocity), \"angular_velocity\": single(body.spin)}",
               "backward_error"},
        Defect{"nothing_done", "if approach < 0 and movable:", "if False:", "non_penetration"},
        Defect{"matrix_left_out", "return reply if matrix is None else", "return reply if True else", "finite",
               "reflection.py"},
        Defect{"angular_term_subtracted", "+ sum(t[i] * t[j]", "- sum(t[i] * t[j]", "definite", "reflection.py"}),
    name_of);

}  // namespace
}  // namespace carom::tests
