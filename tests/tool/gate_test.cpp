// SPDX-License-Identifier: BSL-1.0
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
  const RunResult result = run_carom(
      {"gate", "--cases", "20", "--families", "near_head_on", "--deviates", few_families_judge_no, "--format", "json"});
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

  // Every number of the shrunk collision is a multiple of 1/32.
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

std::string report_listing(const std::vector<std::string>& witnesses) {
  json violations = json::array();
  for (const std::string& witness : witnesses) {
    violations.push_back({{"invariant", "restitution"}, {"witness", witness}});
  }
  const json judged{{"name", "old"}, {"violations", violations}};
  const json absent{{"name", "other"}, {"status", "absent"}};
  return json{{"carom", "0.1.0"}, {"subjects", {judged, absent}}}.dump();
}

RunResult quick_gate(const std::filesystem::path& out) {
  return run_carom({"gate", "frictionless-double", "--families", "generic", "--deviates", few_families_judge_no,
                    "--cases", "5", "--out", out.string()});
}

TEST(GateCommand, RemovesTheWitnessesThatTheOldReportListsAndNothingElse) {
  const TemporaryDirectory out;
  std::filesystem::create_directories(out.path() / "witnesses" / "below");
  const std::vector<std::string> kept{
      out.write("witnesses/mine.json", "{}"), out.write("witnesses/unlisted.restitution.json", "{}"),
      out.write("outside.restitution.json", "{}"), out.write("witnesses/below/x.restitution.json", "{}"),
      out.write("witnesses/old.no_invariant.json", "{}")};
  const std::string listed = out.write("witnesses/old.restitution.json", "{}");
  const std::filesystem::path link = out.path() / "witnesses" / "link.restitution.json";
  std::filesystem::create_symlink(out.path() / "outside.restitution.json", link);
  (void)out.write("report.json",
                  report_listing({"witnesses/old.restitution.json", "witnesses/old.no_invariant.json",
                                  "witnesses/link.restitution.json", "witnesses/below/x.restitution.json",
                                  "witnesses/../outside.restitution.json", "outside.restitution.json",
                                  (out.path() / "outside.restitution.json").string(), "witnesses/absent.push.json", "",
                                  "witnesses/", "witnesses/.."}));
  const RunResult run = quick_gate(out.path());
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_FALSE(std::filesystem::exists(listed));
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  for (const std::string& file : kept) {
    EXPECT_TRUE(std::filesystem::exists(file)) << file;
  }
}

TEST(GateCommand, RemovesNothingWithoutAReportOfItsOwn) {
  const std::string listed = "witnesses/old.restitution.json";
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[3]"), std::string(R"({"carom": "0.1.0", "subjects": 3})"),
        std::string(R"({"carom": "0.1.0", "subjects": [{"violations": [{"witness": 3}]}]})"),
        R"({"subjects": [{"violations": [{"witness": ")" + listed + R"("}]}]})"}) {
    const TemporaryDirectory out;
    std::filesystem::create_directories(out.path() / "witnesses");
    const std::string witness = out.write(listed, "{}");
    (void)out.write("report.json", text);
    EXPECT_EQ(quick_gate(out.path()).exit_status, 0) << text;
    EXPECT_TRUE(std::filesystem::exists(witness)) << text;
  }
}

TEST(GateCommand, RemovesNothingThroughASymbolicLink) {
  const TemporaryDirectory elsewhere;
  const TemporaryDirectory out;
  const std::string witness = elsewhere.write("old.restitution.json", "{}");
  std::filesystem::create_directory_symlink(elsewhere.path(), out.path() / "witnesses");
  (void)out.write("report.json", report_listing({"witnesses/old.restitution.json"}));
  (void)quick_gate(out.path());
  EXPECT_TRUE(std::filesystem::exists(witness));
}

TEST(GateCommand, ReportsAreWrittenAndTheNextRunRemovesItsWitnesses) {
  const TemporaryDirectory out;
  const RunResult result =
      run_carom({"gate", "reflection-in-basis-double", "frictionless-double", "--families", "head_on", "--deviates",
                 few_families_judge_no, "--cases", "60", "--out", out.path().string()});
  EXPECT_EQ(result.exit_status, 1);

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

  EXPECT_EQ(quick_gate(out.path()).exit_status, 0);
  EXPECT_TRUE(std::filesystem::is_empty(out.path() / "witnesses"));
}

TEST(GateCommand, EndsAtTheFirstViolationWhereAskedAndItsWitnessReplays) {
  const TemporaryDirectory out;
  const RunResult result =
      run_carom({"gate", "reflection-in-basis-double", "--fail-fast", "--out", out.path().string()});
  EXPECT_EQ(result.exit_status, 1) << result.errors;
  const json subject = json::parse(content_of(out.path() / "report.json")).at("subjects").at(0);
  ASSERT_EQ(subject.at("violations").size(), 1U);
  EXPECT_EQ(subject.at("violations").at(0).at("count"), 1);
  const std::string witness = (out.path() / subject.at("violations").at(0).at("witness").get<std::string>()).string();
  EXPECT_EQ(run_carom({"replay", witness}).exit_status, 1);
  EXPECT_NE(result.output.find("to its first violation"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("what is wrong: Only 1 violated case was examined"), std::string::npos) << result.output;
  for (const char* hint : {"where:", "look at:"}) {
    EXPECT_EQ(result.output.find(hint), std::string::npos) << "one case gives no hint: " << result.output;
  }
}

TEST(GateCommand, SaysHowManyCasesABudgetWasEnoughFor) {
  const RunResult result = run_carom({"gate", "frictionless-double", "--families", "generic,separating", "--deviates",
                                      few_families_judge_no, "--budget", "0.2s"});
  EXPECT_EQ(result.exit_status, 0) << result.output;
  EXPECT_NE(result.output.find("200 ms on 2 families in turn"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("cases in 200 ms; the fewest cases are"), std::string::npos) << result.output;
}

TEST(GateCommand, DigitsDecideInPlaceOfUlps) {
  // The limit of a hundredth of an ulp is less than any rounding. Three digits are half of the digits of binary32.
  const std::vector<std::string> strict{"gate", "frictionless-float", "--families",          "elastic",      "--cases",
                                        "40",   "--deviates",         few_families_judge_no, "--limit-ulps", "0.01"};
  EXPECT_EQ(run_carom(strict).exit_status, 1);
  std::vector<std::string> lenient(strict.begin(), strict.end() - 2);
  lenient.insert(lenient.end(), {"--digits", "3"});
  EXPECT_EQ(run_carom(lenient).exit_status, 0);
}

TEST(GateCommand, JudgesExactlyWhereAskedAndSaysSo) {
  const std::vector<std::string> arguments{
      "gate", "reflection-in-basis-double", "--families", "near_head_on", "--cases", "10", "--format"};
  const auto with = [&](std::initializer_list<const char*> more) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), more.begin(), more.end());
    return run_carom(all).output;
  };
  json exact = json::parse(with({"json", "--exact"}));
  const json filtered = json::parse(with({"json"}));
  EXPECT_EQ(exact.at("yardstick").at("exact"), true);
  EXPECT_FALSE(filtered.at("yardstick").contains("exact"));
  EXPECT_EQ(exact.at("subjects").at(0).at("families").at(0).at("invariants"),
            filtered.at("subjects").at(0).at("families").at(0).at("invariants"));
  const std::string text = with({"text", "--exact", "--out", TemporaryDirectory().path().c_str()});
  EXPECT_NE(text.find("judged only in exact arithmetic"), std::string::npos) << text;
  EXPECT_NE(text.find(" --exact\n"), std::string::npos) << "the command that replays: " << text;
  EXPECT_EQ(with({"text"}).find("exact arithmetic"), std::string::npos);
}

TEST(GateCommand, WrongUsageEndsInTwoAndSaysWhy) {
  struct WrongUse {
    std::vector<std::string> arguments;
    const char* said;
  };
  const std::vector<WrongUse> table{
      {{}, "no command is given"},
      {{"gate", "no-such-subject"}, "no-such-subject"},
      {{"gate", "--families", "generic,no_such_family"}, "no_such_family"},
      {{"gate", "--cases", "0"}, "--cases"},
      {{"gate", "--cases", "many"}, "--cases"},
      {{"gate", "--budget", "10"}, "--budget: expected a number and a unit"},
      {{"gate", "--budget", "10 s"}, "--budget"},
      {{"gate", "--budget", "0s"}, "--budget"},
      {{"gate", "--budget", "-1s"}, "--budget"},
      {{"gate", "--budget", "5d"}, "--budget"},
      {{"gate", "--budget", "nans"}, "--budget"},
      {{"gate", "--budget", "1e3s"}, "--budget"},
      {{"gate", "--budget", "s"}, "--budget"},
      {{"gate", "--budget", "1001h"}, "--budget"},
      {{"gate", "--budget", "1s", "--cases", "5"}, "--cases"},
      {{"gate", "--limit-ulps", "-1"}, "--limit-ulps"},
      {{"gate", "--limit-ulps", "nan"}, "--limit-ulps"},
      {{"gate", "--digits", "0"}, "--digits"},
      {{"gate", "--digits", "3", "--limit-ulps", "32"}, "--limit-ulps excludes --digits"},
      {{"plan", "x", "--digits", "3", "--limit-ulps", "32"}, "--limit-ulps excludes --digits"},
      {{"gate", "--unknown"}, "--unknown"},
      {{"gate", "frictionles-double"}, "did you mean 'frictionless-double'?"},
      {{"gate", "--families", "head_no"}, "did you mean 'head_on'?"},
      {{"gate", "--famlies=generic"}, "Did you mean '--families'?"},
      {{"gat", "frictionless-double"}, "Did you mean 'gate'?"},
      {{"chart", "--out", "/dev/null/out", "frictionless-duoble"}, "did you mean 'frictionless-double'?"},
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

TEST(GateCommand, AnOptionForNamesTakesOneWord) {
  const RunResult run = run_carom({"gate", "--families", "generic,head_on", "frictionless-double", "--families",
                                   "elastic", "--deviates", few_families_judge_no, "--cases", "2", "--format", "json"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  const json report = json::parse(run.output);
  EXPECT_EQ(report.at("subjects").size(), 1U);
  EXPECT_EQ(report.at("subjects").at(0).at("families").size(), 3U);
}

TEST(GateCommand, SaysThatTheWorkingDirectoryIsGone) {
  const RunResult run = run_program(
      "/bin/sh", {"-c", R"(gone=$(mktemp -d); cd "$gone"; rmdir "$gone"; exec "$0" gate frictionless-double --out r)",
                  carom_program()});
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_NE(run.errors.find("the working directory does not exist any more"), std::string::npos) << run.errors;
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
