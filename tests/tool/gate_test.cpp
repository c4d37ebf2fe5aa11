// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

TEST(GateCommand, SoundSubjectsEndInZero) {
  const RunResult result = run_carom({"gate", "frictionless-double", "reflection-float", "--cases", "20"});
  EXPECT_EQ(result.exit_status, 0) << result.output;
  EXPECT_TRUE(result.errors.empty()) << "progress belongs on a terminal alone: " << result.errors;
}

TEST(GateCommand, DefaultDoesNotCountWhatIsExpectedToFail) {
  const RunResult result = run_carom({"gate", "--cases", "20", "--families", "near_head_on", "--format", "json"});
  EXPECT_EQ(result.exit_status, 0);
  bool saw_violated = false;
  const json report = json::parse(result.output);
  for (const json& subject : report.at("subjects")) {
    saw_violated = saw_violated || (subject.at("status") == "violated" && !subject.at("counts").get<bool>());
  }
  EXPECT_TRUE(saw_violated) << "the subjects that are kept because they fail are shown";
}

TEST(GateCommand, NoteMethodViolatesRestitutionNearHeadOnAndItsWitnessReplays) {
  const TemporaryDirectory out;
  const RunResult result = run_carom({"gate", "reflection-in-basis-double", "--families", "near_head_on", "--cases",
                                      "200", "--out", out.path().string()});
  EXPECT_EQ(result.exit_status, 1);
  const auto file = out.path() / "witnesses" / "reflection-in-basis-double.restitution.json";
  ASSERT_TRUE(std::filesystem::exists(file)) << result.output;
  const json witness = json::parse(content_of(file));
  EXPECT_EQ(witness.at("family"), "near_head_on");

  // For pencil and paper: every number of the collision has at most five bits.
  for (const char* body : {"a", "b"}) {
    for (const char* field : {"position", "velocity", "angular_velocity"}) {
      for (const json& number : witness.at("collision").at(body).at(field)) {
        const double scaled = number.get<double>() * 32;
        EXPECT_EQ(scaled, static_cast<double>(static_cast<int>(scaled))) << body << ' ' << field;
      }
    }
  }

  const RunResult replayed = run_carom({"replay", file.string(), "--format", "json"});
  EXPECT_EQ(replayed.exit_status, 1);
  EXPECT_EQ(json::parse(replayed.output).at("verdicts").at("restitution"), witness.at("verdict"));
  const RunResult other = run_carom({"replay", file.string(), "--subject", "reflection-double"});
  EXPECT_EQ(other.exit_status, 0) << other.output;
}

TEST(GateCommand, SameSeedGivesTheSameReportOnAnyNumberOfThreads) {
  const auto report = [](const std::string& seed, const std::string& jobs) {
    const RunResult result =
        run_carom({"gate", "frictionless-float", "reflection-in-basis-double", "--cases", "120", "--families",
                   "generic,head_on", "--format", "json", "--seed", seed, "--jobs", jobs});
    json parsed = json::parse(result.output);
    parsed.at("environment").erase("date");
    for (json& subject : parsed.at("subjects")) {
      subject.erase("nanoseconds_per_solve");
    }
    return parsed;
  };
  EXPECT_EQ(report("5", "1"), report("5", "3"));
  EXPECT_NE(report("5", "1").at("subjects"), report("6", "1").at("subjects"));
}

TEST(GateCommand, ReportsAreWrittenAndOldWitnessesRemoved) {
  const TemporaryDirectory out;
  std::filesystem::create_directories(out.path() / "witnesses");
  const std::string stale = out.write("witnesses/old.restitution.json", "{}");
  const std::string not_ours = out.write("witnesses/mine.json", "{}");
  const RunResult result = run_carom({"gate", "reflection-in-basis-double", "frictionless-double", "--families",
                                      "head_on", "--cases", "60", "--out", out.path().string()});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_FALSE(std::filesystem::exists(stale));
  EXPECT_TRUE(std::filesystem::exists(not_ours));

  const json report = json::parse(content_of(out.path() / "report.json"));
  EXPECT_EQ(report.at("exit_status"), 1);
  const json& subject = report.at("subjects").at(0);
  ASSERT_FALSE(subject.at("violations").empty());
  for (const json& violation : subject.at("violations")) {
    EXPECT_TRUE(std::filesystem::exists(out.path() / violation.at("witness").get<std::string>()));
  }

  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_file((out.path() / "junit.xml").c_str()));
  const pugi::xml_node failed = junit.child("testsuites").child("testsuite");
  EXPECT_EQ(failed.attribute("failures").as_uint(), subject.at("violations").size());
  EXPECT_EQ(failed.next_sibling("testsuite").attribute("failures").as_int(), 0);
  EXPECT_GT(failed.next_sibling("testsuite").attribute("tests").as_int(), 0);
}

TEST(GateCommand, DigitsDecideInPlaceOfUlps) {
  // A hundredth of an ulp is less than any rounding; three digits are half of what binary32 has.
  const std::vector<std::string> strict{"gate", "frictionless-float", "--families", "elastic", "--cases",
                                        "40",   "--limit-ulps",       "0.01"};
  EXPECT_EQ(run_carom(strict).exit_status, 1);
  std::vector<std::string> lenient = strict;
  lenient.insert(lenient.end(), {"--digits", "3"});
  EXPECT_EQ(run_carom(lenient).exit_status, 0);
}

TEST(GateCommand, WrongUsageEndsInTwoAndSaysWhy) {
  struct WrongUse {
    std::vector<std::string> arguments;
    const char* said;
  };
  const std::vector<WrongUse> table{
      {{}, "a command is needed"},
      {{"gate", "no-such-subject"}, "no-such-subject"},
      {{"gate", "--families", "generic,no_such_family"}, "no_such_family"},
      {{"gate", "--cases", "0"}, "--cases"},
      {{"gate", "--cases", "many"}, "--cases"},
      {{"gate", "--limit-ulps", "-1"}, "--limit-ulps"},
      {{"gate", "--limit-ulps", "nan"}, "--limit-ulps"},
      {{"gate", "--digits", "0"}, "--digits"},
      {{"gate", "--unknown"}, "--unknown"},
      {{"gate", "--format", "xml"}, "--format"},
      {{"gate", "frictionless-double", "--cases", "1", "--out", "/dev/null/out"}, "--out"},
      {{"replay"}, "FILE"},
      {{"juggle"}, "juggle"},
  };
  for (const WrongUse& wrong : table) {
    const RunResult result = run_carom(wrong.arguments);
    EXPECT_EQ(result.exit_status, 2) << wrong.said;
    EXPECT_NE((result.output + result.errors).find(wrong.said), std::string::npos) << result.output << result.errors;
  }
}

TEST(GateCommand, HelpIsEverywhere) {
  for (const char* command : {"gate", "subjects", "invariants", "families", "replay"}) {
    const RunResult result = run_carom({command, "--help"});
    EXPECT_EQ(result.exit_status, 0);
    EXPECT_NE(result.output.find("Usage"), std::string::npos);
  }
}

}  // namespace
}  // namespace carom::tests
