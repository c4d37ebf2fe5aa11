// SPDX-License-Identifier: BSL-1.0
#include "commands/chart.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <carom/subjects/methods.hpp>

#include "support/changed_subject.hpp"
#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

using namespace tool::chart;

/// A solver that halves all velocities after the impulse, as linear damping by 1/2 does.
Subject damped() {
  return unit::with_outcomes(subjects::methods().front().subject, [](const Collision&, ReportedOutcome& outcome) {
    outcome.a.velocity /= 2;
    outcome.b.velocity /= 2;
  });
}

TEST(MeasuredExactness, LeavesOutCasesThatLeaveTheRangeOfAPrecision) {
  std::vector<subjects::Method> methods = subjects::methods();
  std::erase_if(methods, [](const subjects::Method& one) {
    return one.subject.name != "frictionless-float" && one.subject.name != "frictionless-double";
  });
  ASSERT_EQ(methods.size(), 2U);
  Collision c;
  c.a.position = {0, 1, 0};
  c.a.velocity = {0, -1, 0};
  c.a.principal_inertia.setConstant(1e37);
  c.b.position = {0, -1, 0};
  ChartedSubjects charted({methods[0].subject, methods[1].subject});
  const std::vector<report::Exactness> measured =
      measured_exactness(charted, std::vector{c}, 32, {}, AnswersOfCoulomb::found);
  EXPECT_EQ(measured[0].cases, 0U);
  EXPECT_EQ(measured[1].cases, 1U);
}

TEST(MeasuredExactness, TakesOutDeclaredEffects) {
  const std::vector<Collision> collisions = colliding_cases(*properties::family_named("generic"), 1, 20);
  Subject declares = damped();
  declares.effects[DeclaredEffect::linear_damping] = 0.5;
  ChartedSubjects charted({declares, damped()});
  const std::vector<report::Exactness> measured =
      measured_exactness(charted, collisions, 32, {}, AnswersOfCoulomb::found);
  EXPECT_GT(measured[0].cases, 15U);
  EXPECT_EQ(measured[0].failures, 0U);
  EXPECT_EQ(measured[1].failures, measured[1].cases);
}

const std::vector<std::string> methods{"frictionless-double", "reflection-double", "reflection-in-basis-double",
                                       "coulomb-double"};

/// One run of `carom chart`, which all tests of Chart share.
struct ChartRun {
  TemporaryDirectory directory;
  std::filesystem::path out = directory.path() / "it's charts";
  RunResult run = run_carom({"chart", "--cases", "8", "--repetitions", "1", "--out", out.string()}, methods);
  json record = json::parse(content_of(out / "chart.json"));
};

const ChartRun& shared() {
  static const ChartRun run;
  return run;
}

std::filesystem::path out() { return shared().out; }
const RunResult& run() { return shared().run; }
const json& record() { return shared().record; }

json method(const std::string& name) {
  const json& all = record().at("methods");
  const auto found = std::ranges::find_if(all, [&](const json& each) { return each.at("name") == name; });
  return found == all.end() ? json() : *found;
}

json sweep_line(const std::string& sweep, const std::string& name) {
  for (const json& each : record().at("sweeps")) {
    for (const json& line : each.at("lines")) {
      if (each.at("name") == sweep && line.at("method") == name) {
        return line;
      }
    }
  }
  return {};
}

/// A README is about 830 pixels wide. tests/report/chart_test.cpp tests the contrast of texts.
TEST(Chart, EveryPictureIsSvgWithoutScriptsAndReadableAtTheWidthOfAReadme) {
  ASSERT_EQ(run().exit_status, 0) << run().errors;
  std::size_t pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out())) {
    if (entry.path().extension() != ".svg") {
      continue;
    }
    ++pictures;
    const std::string content = content_of(entry.path());
    unit::expect_in(content, {"prefers-color-scheme: dark"});
    EXPECT_TRUE(content.find("[ns]") != std::string::npos || content.find("[ulps") != std::string::npos)
        << entry.path() << " has a unit";
    EXPECT_TRUE(std::filesystem::exists(out() / "gnuplot" / entry.path().stem().concat(".gp")));
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(content.c_str())) << entry.path();
    EXPECT_STREQ(document.document_element().name(), "svg");
    EXPECT_TRUE(document.select_nodes("//*[local-name()='script']").empty()) << entry.path();
    EXPECT_FALSE(document.select_nodes("//*[local-name()='path']").empty()) << entry.path();
    double width = 0;
    ASSERT_EQ(std::sscanf(document.document_element().attribute("viewBox").value(), "0 0 %lf", &width), 1);
    const pugi::xpath_node_set texts = document.select_nodes("//*[local-name()='text']");
    EXPECT_FALSE(texts.empty()) << entry.path();
    for (const pugi::xpath_node& found : texts) {
      const pugi::xml_node style = found.parent();
      const std::string where = entry.path().string() + ": " + found.node().text().get();
      EXPECT_GE(style.attribute("font-size").as_double() * 830 / width, 10) << where;
    }
  }
  // Each of the three laws has a picture of deadlines. Each law that determines one outcome has one of time against
  // backward error, and one for each sweep.
  EXPECT_EQ(pictures, 3 + 2 + 2 * record().at("sweeps").size());
}

TEST(Chart, NamesEveryMethodInTheTableAndInThePictures) {
  unit::expect_in(content_of(out() / "work-precision-reflection.svg"), {"reflection-double", "32 ulps of binary64"});
  unit::expect_in(run().output, {"| reflection-in-basis-double |"});
  EXPECT_EQ(run().output, content_of(out() / "tables.md"));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file((out() / "stability-reflection-tangential_velocity.svg").c_str()));
  for (const char* name : {"reflection-in-basis-double", "reflection-double"}) {
    EXPECT_TRUE(document.select_node((std::string("//*[local-name()='text'][.='") + name + "']").c_str())) << name;
  }
}

TEST(Chart, FindsThatTheNotesMethodFailsNearHeadOnAndTheBasisFreeMethodNowhere) {
  const json note = method("reflection-in-basis-double").at("families");
  const json basis_free = method("reflection-double").at("families");
  EXPECT_GT(note.at("near_head_on").at("failures"), 0);
  EXPECT_EQ(note.at("generic").at("failures"), 0);
  for (const auto& [family, measured] : basis_free.items()) {
    EXPECT_EQ(measured.at("failures"), 0) << family;
    EXPECT_EQ(measured.at("cases"), 8) << family;
    EXPECT_GT(measured.at("nanoseconds").at("median"), 0) << family;
    EXPECT_GE(measured.at("digits").at("median"), measured.at("digits").at("worst")) << family;
    EXPECT_LE(measured.at("backward_error_ulps").at("median"), measured.at("backward_error_ulps").at("worst"));
  }
  EXPECT_FALSE(note.contains("separating")) << "nothing collides there";
  EXPECT_FALSE(note.contains("invalid"));
  const json line = sweep_line("tangential_velocity", "reflection-in-basis-double");
  EXPECT_LT(line.at("leaves_limit_at"), 1);
  EXPECT_GT(line.at("leaves_limit_at"), 1e-13);
  EXPECT_TRUE(sweep_line("tangential_velocity", "reflection-double").at("leaves_limit_at").is_null());
  EXPECT_TRUE(sweep_line("condition_number", "frictionless-double").at("leaves_limit_at").is_null());
}

TEST(Chart, DataFilesHaveALineForEachMeasurement) {
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  const auto families = static_cast<long>(method("reflection-double").at("families").size());
  EXPECT_EQ(lines(content_of(out() / "work-precision.csv")), 1 + 4 * families);
  long points = 0;
  for (const json& sweep : record().at("sweeps")) {
    for (const json& line : sweep.at("lines")) {
      points += static_cast<long>(line.at("points").size());
    }
  }
  EXPECT_EQ(lines(content_of(out() / "stability.csv")), 1 + points);
  std::istringstream steps(content_of(out() / "deadline.csv"));
  std::string line;
  std::getline(steps, line);
  EXPECT_EQ(line, "model,digits,ns,share,method");
  EXPECT_TRUE(std::getline(steps, line));
}

TEST(Chart, MeasuresTheLawCoulombByItsNearestAnswer) {
  const json families = method("coulomb-double").at("families");
  EXPECT_FALSE(families.empty());
  for (const auto& [family, measured] : families.items()) {
    EXPECT_EQ(measured.at("failures"), 0) << family;
    // At a grazing contact, rounding decides most of the small change.
    EXPECT_TRUE(family == "grazing" || measured.at("digits").at("median") > 2) << family;
    EXPECT_TRUE(measured.at("backward_error_ulps").is_null());
  }
}

/// A program that ignores contacts. Its name has characters that CSV and gnuplot would misread.
TEST(ChartOfSubjects, DrawsStabilityMapsOfAProgram) {
  const TemporaryDirectory directory;
  const std::string out = (directory.path() / "out").string();
  const RunResult run =
      run_carom({"chart", std::string("exec:") + CAROM_MISBEHAVING + " 'idle={}' '`touch ran`, \"quoted\"'",
                 "frictionless-double", "--cases", "3", "--repetitions", "1", "--out", out});
  ASSERT_EQ(run.exit_status, 0) << run.errors;
  const std::string name = "`touch ran`, \"quoted\"";
  const json record = json::parse(content_of(out + "/chart.json"));
  EXPECT_EQ(record.at("methods").size(), 1U) << "only a method is timed";
  for (const json& sweep : record.at("sweeps")) {
    ASSERT_EQ(sweep.at("lines").size(), 2U);
    EXPECT_TRUE(sweep.at("lines")[0].at("leaves_limit_at").is_null()) << sweep.at("name");
    EXPECT_EQ(sweep.at("lines")[1].at("method"), name);
    EXPECT_TRUE(sweep.at("lines")[1].at("leaves_limit_at").is_number()) << sweep.at("name");
  }
  unit::expect_in(content_of(out + "/stability.csv"), {",\"`touch ran`, \"\"quoted\"\"\","});
  unit::expect_in(content_of(out + "/stability-frictionless-slenderness.svg"), {"touch ran"});
  EXPECT_FALSE(std::filesystem::exists(out + "/ran"));
}

TEST(ChartOfSubjects, AProgramThatFailsAgainAndAgainLosesNoOtherPoint) {
  const TemporaryDirectory directory;
  const std::string out = (directory.path() / "out").string();
  expect_error(run_carom({"chart", std::string("exec:") + CAROM_MISBEHAVING + " exit-in-the-middle crasher",
                          "bullet-double", "--cases", "3", "--out", out}),
               {"crasher: ", "no later points"});
  std::size_t of_bullet = 0;
  std::size_t of_crasher = 0;
  const json record = json::parse(content_of(out + "/chart.json"));
  for (const json& sweep : record.at("sweeps")) {
    for (std::size_t s = 0; s < 2; ++s) {
      for (const json& point : sweep.at("lines")[s].at("points")) {
        (s == 0 ? of_crasher : of_bullet) += point.at("cases").get<std::size_t>();
      }
    }
  }
  EXPECT_TRUE(record.at("methods").empty());
  EXPECT_FALSE(std::filesystem::exists(out + "/work-precision-frictionless.svg")) << "no method is timed";
  EXPECT_LE(of_crasher, 300U) << "it fails at every third collision, and at most a hundred times";
  EXPECT_GT(of_crasher, 0U);
  EXPECT_GT(of_bullet, 100U);
}

TEST(ChartUsage, RefusesASubjectThatCannotBeChartedAndNamesIt) {
  const TemporaryDirectory directory;
  const auto errors_of = [&](const std::string& subject) {
    const RunResult run = run_carom({"chart", subject, "--out", directory.path().string()});
    expect_error(run, {subject});
    return run.errors;
  };
  unit::expect_in(errors_of("no-such-method"), {"there is no subject"});
  unit::expect_in(errors_of("bullet-double-coulomb"), {"its law `coulomb` determines none"});
  unit::expect_in(errors_of("exec:/no/such/program"), {"No such file"});
}

TEST(ChartUsage, WritesTheDataIfGnuplotIsMissingOrWritesNoPicture) {
  const TemporaryDirectory directory;
  // carom runs: gnuplot -e "cd 'DIRECTORY'" gnuplot/NAME.gp
  const std::string gnuplot =
      directory.write("gnuplot", "#!/bin/sh\neval \"$2\"\necho '<svg/>' > $(basename $3 .gp).svg\n");
  std::filesystem::permissions(gnuplot, std::filesystem::perms::owner_all);
  const std::filesystem::path out = directory.path() / "out";
  for (const auto& [path, says] :
       {std::pair{std::string("/no/such"), "install gnuplot"},
        std::pair{directory.path().string() + ":/usr/bin:/bin", "gnuplot wrote no picture"}}) {
    std::filesystem::remove_all(out);
    expect_error(run_program("/usr/bin/env", {"PATH=" + path, carom_program(), "chart", "frictionless-double",
                                              "--cases", "2", "--repetitions", "1", "--out", out.string()}),
                 {says});
    EXPECT_TRUE(std::filesystem::exists(out / "chart.json"));
    EXPECT_TRUE(std::filesystem::exists(out / "gnuplot" / "work-precision-frictionless.gp"));
  }
}

RunResult domain(const std::vector<std::string>& more) { return run_carom({"domain", "--cases", "2"}, more); }

/// The schema accepts the record, and does not accept it with another field.
void expect_schema_accepts(json record) {
  const TemporaryDirectory directory;
  const std::string schema = std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/domain.schema.json";
  const std::string file = directory.write("accepted.json", record.dump());
  record["mood"] = "good";
  const std::string rejected = directory.write("rejected.json", record.dump());
  EXPECT_EQ(accepted_by(schema, {file, rejected}), std::vector<std::string>{file});
}

/// J⁻¹ in world axes loses the angular momentum of slender bodies.
TEST(DomainCommand, MeasuresWhereASolverFailsAndTheDomainThatItWritesIsSound) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "domain.json").string();
  const RunResult result = domain({"reflection-world-double", "--out", file, "--format", "json"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const json record = json::parse(result.output);
  EXPECT_EQ(record.at("subject"), "reflection-world-double");
  EXPECT_EQ(record.at("faces").size(), 18U);
  std::vector<std::string> failing;
  for (const json& face : record.at("faces")) {
    if (!face.at("beyond").is_null()) {
      failing.push_back(face.at("quantity"));
      EXPECT_TRUE(face.at("beyond").contains("collision")) << face;
      EXPECT_FALSE(face.at("beyond").at("invariant").get<std::string>().empty()) << face;
    }
  }
  EXPECT_EQ(failing, std::vector<std::string>{"moment_ratio"});
  EXPECT_EQ(json::parse(content_of(file)), record.at("domain"));
  EXPECT_GT(record.at("cases"), 0);
  EXPECT_EQ(record.at("not_judged").at("at_declared_limit"), 0);
  EXPECT_EQ(run_carom({"gate", "reflection-world-double", "--within", file, "--cases", "5"}).exit_status, 0);
}

TEST(DomainCommand, WithoutDigitsPrintsAndDrawsOnlyWhereASubjectHolds) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "domain.svg").string();
  const RunResult result = domain({"frictionless-double", "--picture", file, "--deviates", "backward_error"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  unit::expect_in(result.output, {"moment_ratio            most      1e+08          1e+08  the search ends here",
                                  "\nNot judged: backward_error.\n"});
  const std::string picture = content_of(file);
  EXPECT_EQ(picture.find("loses digits"), std::string::npos);
  unit::expect_in(picture, {">games<"});
}

TEST(DomainCommand, EndsInOneIfTheSubjectFailsWhereTheSearchStarts) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "domain.json").string();
  const std::vector<std::string> subject{"reflection-in-basis-double", "--core", "speed=1:2,spin=0:0"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = subject;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return domain(arguments);
  };
  const RunResult result = with({"--out", file});
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(result.exit_status, 1) << result.output << result.errors;
  unit::expect_in(result.output, {" in these ranges, so it has no domain around them. Choose other ranges by --core."});

  const json before = json::parse(with({"--format", "json"}).output);
  const std::string invariant = before.at("in_core").at("invariant");
  const json after = json::parse(with({"--format", "json", "--deviates", invariant}).output);
  EXPECT_EQ(after.at("deviates"), json::array({invariant}));
  EXPECT_FALSE(before.contains("deviates"));
  ASSERT_TRUE(after.contains("in_core")) << after;
  EXPECT_NE(after.at("in_core").at("invariant"), invariant);
  expect_schema_accepts(after);
}

/// In binary32, rounding passes 32 ulps of itself long before it passes three digits.
TEST(DomainCommand, WithDigitsDrawsWhereASubjectHoldsLosesDigitsAndFails) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "domain.svg").string();
  const RunResult result = domain({"reflection-world-float", "--digits", "3", "--picture", file, "--beside",
                                   "size=0.1:10,restitution=:0.9", "--format", "json"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const json record = json::parse(result.output);
  expect_schema_accepts(record);
  const auto end_of_moments = [](const json& ends) {
    for (const json& face : ends.at("faces")) {
      if (face.at("quantity") == "moment_ratio") {
        return face.at("value").get<double>();
      }
    }
    return 0.0;
  };
  const double end = end_of_moments(record);
  const double stricter_end = end_of_moments(record.at("stricter"));
  EXPECT_GT(end, 2 * stricter_end);
  EXPECT_GT(stricter_end, 2);

  pugi::xml_document picture;
  ASSERT_TRUE(picture.load_file(file.c_str()));
  EXPECT_EQ(picture.select_nodes("/svg/g[@class='bar']").size(), 12U);
  const auto bar = [&](const char* quantity) {
    return picture.select_node((std::string("/svg/g[@class='bar'][text='") + quantity + "']").c_str()).node();
  };
  const auto count = [](const pugi::xml_node& node, const char* colour) {
    return node.select_nodes((std::string("rect[@fill='") + colour + "']").c_str()).size();
  };
  constexpr const char* blue = "#0072b2";
  constexpr const char* orange = "#e69f00";
  constexpr const char* black = "#000000";
  EXPECT_EQ(count(bar("moment_ratio"), blue), 1U);
  EXPECT_EQ(count(bar("moment_ratio"), orange), 1U);
  for (const char* quantity : {"size", "restitution"}) {
    EXPECT_EQ(count(bar(quantity), black), 1U) << quantity;
  }
  EXPECT_EQ(count(bar("mass"), black), 0U);
  unit::expect_in(content_of(file), {"holds to 32 ulps", "loses digits, holds to 3 digits", "fails", "kg"});
}

}  // namespace
}  // namespace carom::tests
