// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/properties/cases/domain.hpp>

#include "support/expect_in.hpp"
#include "support/program.hpp"

/// `carom gate`, and what a subject does not claim: deviations, effects, and cases outside of its domain.
namespace carom::tests {
namespace {

using nlohmann::json;

TEST(GateCommand, EndsInZeroForSoundSubjects) {
  const RunResult result = run_carom({"gate", "frictionless-double", "reflection-float", "--cases", "20"});
  EXPECT_EQ(result.exit_status, 0) << result.output;
  EXPECT_TRUE(result.errors.empty()) << "progress belongs on a terminal alone: " << result.errors;
}

TEST(GateCommand, JudgesOneSolverOfEachLawUnlessAllAreAskedFor) {
  const auto judged_by = [](const std::vector<std::string>& arguments) {
    const json report =
        json::parse(run_carom(arguments, {"--cases", "1", "--families", "head_on", "--format", "json"}).output);
    std::set<std::string> names;
    for (const json& subject : report.at("subjects")) {
      names.insert(subject.at("name"));
    }
    return names;
  };
  const std::set<std::string> by_default = judged_by({"gate"});
  for (const char* name : {"frictionless-double", "reflection-double", "sticking-double", "rough-double",
                           "coulomb-double", "reflection-in-basis-double"}) {
    EXPECT_TRUE(by_default.contains(name)) << name;
  }
  EXPECT_FALSE(by_default.contains("reflection-llt-float"));
  EXPECT_TRUE(judged_by({"gate", "--all"}).contains("reflection-llt-float"));
  EXPECT_FALSE(judged_by({"gate", "rough-float"}).contains("rough-double"));
  EXPECT_TRUE(judged_by({"gate", "rough-float", "--all"}).contains("rough-double"));
}

TEST(GateCommand, FindsTheNotesMethodFaultyNearHeadOnAndItsWitnessReplaysShrunkAndDrawn) {
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
  const json drawn = json::parse(run_carom({"replay", file.string(), "--drawn", "--format", "json"}).output);
  EXPECT_EQ(drawn.at("collision"), witness.at("drawn"));
  EXPECT_EQ(drawn.at("verdicts").at("restitution"), witness.at("drawn_verdict"));
  const RunResult numbered =
      run_carom({"replay", "--family", "near_head_on", "--case", std::to_string(witness.at("case").get<int>()),
                 "--subject", "reflection-in-basis-double", "--format", "json"});
  EXPECT_EQ(numbered.exit_status, 1) << numbered.errors;
  EXPECT_EQ(json::parse(numbered.output).at("collision"), witness.at("drawn"));
}

TEST(GateCommand, GivesTheSameReportForTheSameSeedOnAnyNumberOfThreads) {
  const auto report = [](const std::string& seed, const std::string& jobs) {
    const RunResult result =
        run_carom({"gate", "frictionless-float", "reflection-double", "--limit-ulps", "0.001", "--cases", "120",
                   "--families", "generic,head_on", "--format", "json", "--seed", seed, "--jobs", jobs});
    json parsed = json::parse(result.output);
    parsed.at("environment").erase("date");
    for (json& subject : parsed.at("subjects")) {
      subject.erase("nanoseconds_per_solve");
    }
    return parsed;
  };
  const json first = report("5", "1");
  EXPECT_EQ(first, report("5", "3"));
  EXPECT_NE(first.at("subjects"), report("6", "1").at("subjects"));
}

TEST(GateCommand, WithABudgetSaysHowManyCasesItWasEnoughFor) {
  const RunResult result = run_carom({"gate", "frictionless-double", "--families", "generic,separating", "--deviates",
                                      few_families_judge_no, "--budget", "0.2s"});
  EXPECT_EQ(result.exit_status, 0) << result.output;
  unit::expect_in(result.output, {"200 ms on 2 families in turn", "cases in 200 ms; the fewest cases are"});
}

TEST(GateCommand, WithDigitsJudgesByDigitsInPlaceOfUlps) {
  // The limit of a hundredth of an ulp is less than any rounding. Three digits are half of the digits of binary32.
  const std::vector<std::string> gate{"gate", "frictionless-float", "--families",         "elastic", "--cases",
                                      "40",   "--deviates",         few_families_judge_no};
  EXPECT_EQ(run_carom(gate, {"--limit-ulps", "0.01"}).exit_status, 1);
  EXPECT_EQ(run_carom(gate, {"--digits", "3"}).exit_status, 0);
}

/// tests/equality shows that the counts are the same.
TEST(GateCommand, WithExactSaysSo) {
  const auto with = [&](const std::vector<std::string>& more) {
    return run_carom({"gate", "reflection-in-basis-double", "--families", "near_head_on", "--cases", "3"}, more).output;
  };
  EXPECT_EQ(json::parse(with({"--format", "json", "--exact"})).at("yardstick").at("exact"), true);
  unit::expect_in(with({"--exact", "--out", TemporaryDirectory().path()}),
                  {"judged only in exact arithmetic", " --exact\n"});  // the last stands in the command that replays
  EXPECT_EQ(with({}).find("exact arithmetic"), std::string::npos);
}

TEST(GateCommand, TakesOneWordForAnOptionOfNamesSoThatASubjectMayFollow) {
  const RunResult run = run_carom({"gate", "--families", "generic,head_on", "frictionless-double", "--families",
                                   "elastic", "--deviates", few_families_judge_no, "--cases", "2", "--format", "json"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  const json report = json::parse(run.output);
  EXPECT_EQ(report.at("subjects").size(), 1U);
  EXPECT_EQ(report.at("subjects").at(0).at("families").size(), 3U);
}

TEST(GateCommand, NamesAWorkingDirectoryThatDoesNotExistAnyMore) {
  expect_error(
      run_program("/bin/sh",
                  {"-c", R"(gone=$(mktemp -d); cd "$gone"; rmdir "$gone"; exec "$0" gate frictionless-double --out r)",
                   carom_program()}),
      {"the working directory does not exist any more"});
}

const std::string threshold = R"({"restitution_threshold": 0.5})";
const std::string small_bodies = "size=0.001:0.01,restitution=:0.5";
const std::string never_judged = std::string(few_families_judge_no) + ",unit_scaling";

/// A sound program with the fault or the claim that the words name.
std::string program(const std::string& words) { return std::string("exec:") + CAROM_MISBEHAVING + ' ' + words; }

RunResult gate_of(std::vector<std::string> subjects, const std::vector<std::string>& more) {
  subjects.insert(subjects.begin(), "gate");
  return run_carom(std::move(subjects), more);
}

json report_of(const std::vector<std::string>& subjects, std::vector<std::string> more) {
  more.insert(more.end(), {"--format", "json"});
  return json::parse(gate_of(subjects, more).output);
}

json report_in(const std::string& directory) { return json::parse(content_of(directory + "/report.json")); }

const json& invariants_in(const json& report, std::size_t family) {
  return report.at("subjects").at(0).at("families").at(family).at("invariants");
}

TEST(Deviations, LeaveOutAnInvariantInOneFamilyOrInAllFamilies) {
  const auto with = [](std::vector<std::string> more) {
    more.insert(more.end(), {"--families", "head_on,near_head_on", "--cases", "5"});
    return report_of({"reflection-in-basis-double"}, more);
  };
  const json whole = with({});
  const json report = with({"--deviates", "restitution@head_on,memoryless"});
  const json expected = json::array({"restitution@head_on", "memoryless"});
  EXPECT_EQ(report.at("deviates"), expected);
  EXPECT_EQ(report.at("subjects").at(0).at("deviates"), expected);
  for (const std::size_t family : {0U, 1U}) {
    json rest = invariants_in(whole, family);
    rest.erase("memoryless");
    if (family == 0) {
      rest.erase("restitution");
    }
    EXPECT_EQ(invariants_in(report, family), rest) << family;
  }
  std::string all = few_families_judge_no;
  std::string all_but_one = all;
  for (const json& violation : whole.at("subjects").at(0).at("violations")) {
    for (const char* family : {"head_on", "near_head_on"}) {
      const std::string deviation = violation.at("invariant").get<std::string>() + "@" + family;
      all += ',' + deviation;
      all_but_one += deviation == "restitution@near_head_on" ? "" : ',' + deviation;
    }
  }
  EXPECT_EQ(with({"--deviates", all}).at("exit_status"), 0);
  EXPECT_EQ(with({"--deviates", all_but_one}).at("exit_status"), 1) << "one violation is not left out";
}

TEST(Deviations, MayBeDeclaredByAProgram) {
  const auto introduced_with = [](const std::string& deviates) {
    return report_of({program("'deviates=" + deviates + "' x")}, {"--families", "head_on,separating", "--cases", "5"});
  };
  EXPECT_TRUE(invariants_in(introduced_with("[]"), 1).contains("separating_untouched"));
  const json partly = introduced_with(R"(["separating_untouched@separating"])");
  EXPECT_FALSE(invariants_in(partly, 1).contains("separating_untouched"));
  const json unknown = introduced_with(R"(["separating_untouched@seperating"])");
  EXPECT_EQ(unknown.at("subjects").at(0).at("status"), "error");
}

/// Only a method that forms the collision matrix claims the invariants about this matrix.
TEST(InvariantsOfTheMatrix, AreClaimedOnlyByAMethodThatShowsItsCollisionMatrix) {
  const TemporaryDirectory out;
  const RunResult result = gate_of({"frictionless-double", "reflection-double", "reflection-batch-double"},
                                   {"--cases", "5", "--out", out.path().string()});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  unit::expect_in(result.output, {"  frictionless-double, reflection-batch-double: not claimed (no collision matrix): "
                                  "definite,\n    well_conditioned, matrix_used\n"});
  unit::expect_in(content_of(out.path() / "report.html"), {"because it shows no collision matrix"});
  const json report = report_in(out.path().string());
  for (const auto& [subject, shows] : {std::pair{0U, false}, std::pair{1U, true}, std::pair{2U, false}}) {
    const json& record = report.at("subjects").at(subject);
    const json& invariants = record.at("families").at(0).at("invariants");
    EXPECT_EQ(record.at("shows_collision_matrix"), shows);
    EXPECT_EQ(record.at("not_claimed"),
              shows ? json::array() : json::array({"definite", "well_conditioned", "matrix_used"}));
    for (const char* name : {"definite", "matrix_used"}) {
      EXPECT_EQ(invariants.contains(name), shows) << name;
      EXPECT_TRUE(!shows || invariants.at(name).at("holds") > 0) << name;
    }
  }
}

TEST(DeclaredEffects, AreInTheReportInAReplayAndInAComparison) {
  const TemporaryDirectory directory;
  const auto declaring = [](const std::string& claims) { return program("'claims=" + claims + "' declaring"); };
  const auto gate = [&](const std::string& claims, const std::string& out) {
    return gate_of({declaring(claims)},
                   {"--families", "generic", "--deviates", few_families_judge_no, "--cases", "20", "--out", out});
  };
  const std::string out = (directory.path() / "run").string();
  EXPECT_EQ(gate(threshold, out).exit_status, 1) << "the program does not have the effect";
  const json report = report_in(out);
  EXPECT_EQ(report.at("subjects")[0].at("claims"), json::parse(threshold));
  EXPECT_EQ(
      accepted_by(std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/report.schema.json", {out + "/report.json"})
          .size(),
      1U);
  unit::expect_in(content_of(out + "/report.html"), {"restitution_threshold 0.5 m/s"});
  const std::string witness = report.at("subjects")[0].at("violations")[0].at("witness");
  const RunResult replayed = run_carom({"replay", out + "/" + witness, "--subject", declaring(threshold)});
  EXPECT_EQ(replayed.exit_status, 1) << replayed.errors;
  unit::expect_in(replayed.output, {"declaring declares restitution_threshold 0.5 m/s"});
  const std::string before = (directory.path() / "before").string();
  EXPECT_EQ(gate("{}", before).exit_status, 0);
  const RunResult compared = run_carom({"compare", before, out});
  EXPECT_NE(compared.output.find("the law without restitution_threshold 0.5 m/s"), std::string::npos)
      << compared.output << "a new effect is claimed no longer";
}

/// A program that does nothing declares a slop that excuses this. Shards add up the cases that the slop decides.
TEST(DeclaredEffects, ThatDecideTooManyCasesAreNotJudgedInARunOrInItsShards) {
  const TemporaryDirectory directory;
  const auto path = [&](const char* name) { return (directory.path() / name).string(); };
  const auto with = [](std::vector<std::string> more) {
    more.insert(more.end(), {"--families", "generic", "--cases", "20"});
    return gate_of({program(R"('idle={"slop":1e300}' idle)")}, more);
  };
  EXPECT_EQ(with({"--out", path("whole")}).exit_status, 2);
  (void)with({"--shard", "1/2", "--out", path("first")});
  (void)with({"--shard", "2/2", "--out", path("second")});
  EXPECT_EQ(run_carom({"merge", "--out", path("merged"), path("first"), path("second")}).exit_status, 2);
  const std::string why = "the declared slop 1e+300 m/s decides 20 of 20 colliding cases, which is more than a tenth";
  for (const char* run : {"whole", "merged"}) {
    const json subject = report_in(path(run)).at("subjects")[0];
    EXPECT_EQ(subject.at("status"), "not judged");
    EXPECT_TRUE(subject.at("error").get<std::string>().starts_with(why)) << subject.at("error");
    EXPECT_EQ(subject.at("families")[0].at("decided_by"), json({{"slop", 20}}));
  }
}

TEST(Within, DrawsTheSameCasesIfTheDomainIsGivenByNameAsTextOrInAFile) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("domain.json", R"({"size": [0.1, 10], "speed": [null, 500],
                                                             "distance": [null, 500], "friction": [null, 1]})");
  const auto shown = [&](const std::string& domain) {
    const RunResult result = run_carom({"replay", "--family", "structured", "--case", "7", "--within", domain});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return result.output;
  };
  EXPECT_EQ(shown("games"), shown(file));
  EXPECT_EQ(shown("games"), shown("size=0.1:10,speed=:500,distance=:500,friction=:1"));
  EXPECT_NE(shown("games"), shown("everything"));
}

TEST(Within, IsTheDomainThatAProgramDeclaresUnlessTheCommandLineHasAnother) {
  const auto judged = [](const std::vector<std::string>& subjects, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--families", "head_on", "--deviates", never_judged, "--cases", "4"});
    return gate_of(subjects, more);
  };
  const std::string small = program(R"('domain={"size": [0.001, 0.01]}' small)");
  const std::string large = program(R"('domain={"size": [10, null]}' large)");
  const RunResult declared = judged({small});
  EXPECT_EQ(declared.exit_status, 0) << declared.output << declared.errors;
  unit::expect_in(declared.output, {" within size=0.001:0.01,"});
  unit::expect_in(judged({small}, {"--within", "games"}).output, {" within size=0.1:10,"});
  expect_error(judged({small, large}), {"small declares the domain size=0.001:0.01, and large declares size=10:"});
  expect_error(judged({program(R"('domain={"colour": [1, 2]}' odd)")}), {"odd: the domain in the reply to start: "});
}

TEST(Within, HoldsForWitnessesAndForTheShardsOfARun) {
  const TemporaryDirectory directory;
  const auto path = [&](const char* name) { return (directory.path() / name).string(); };
  const auto gate = [&](const char* name, std::vector<std::string> more) {
    more.insert(more.end(), {"--families", "head_on", "--deviates", never_judged, "--cases", "6", "--out", path(name)});
    return gate_of({"reflection-in-basis-double", "frictionless-double"}, more);
  };
  EXPECT_EQ(gate("whole", {"--within", small_bodies}).exit_status, 1);
  const json whole = report_in(path("whole"));
  EXPECT_EQ(whole.at("within"), json::parse(R"({"size": [0.001, 0.01], "restitution": [null, 0.5]})"));
  const properties::Domain domain = properties::domain_from(small_bodies);
  const json violations = whole.at("subjects")[0].at("violations");
  EXPECT_FALSE(violations.empty());
  for (const json& violation : violations) {
    const json witness =
        json::parse(content_of(directory.path() / "whole" / violation.at("witness").get<std::string>()));
    for (const char* collision : {"collision", "drawn"}) {
      EXPECT_TRUE(contains(domain, collision_from_json(witness.at(collision)))) << witness.at(collision);
    }
  }
  (void)gate("first", {"--within", small_bodies, "--shard", "1/2"});
  (void)gate("second", {"--within", small_bodies, "--shard", "2/2"});
  (void)gate("other", {"--shard", "2/2"});
  EXPECT_EQ(run_carom({"merge", "--out", path("merged"), path("first"), path("second")}).exit_status, 1);
  const json sum = report_in(path("merged"));
  EXPECT_EQ(sum.at("within"), whole.at("within"));
  EXPECT_EQ(sum.at("families"), whole.at("families"));
  expect_error(run_carom({"merge", "--out", path("wrong"), path("first"), path("other")}), {"within: " + small_bodies});
}

/// Just below 1 : 8, the solvers compute torques by plain cross products (impulse/principal_inertia.hpp). A cheaper
/// form of J⁻¹, τ/I₃ + Σ (1/I_k − 1/I₃) e_k (e_k·τ), violates `sticks` here.
TEST(Within, AlmostSlenderBodiesFindsEverySolverSound) {
  const RunResult result =
      run_carom({"gate", "reflection-double", "frictionless-double", "sticking-double", "rough-double",
                 "coulomb-double", "sticking-float", "reflection-float", "--families", "needle_tip", "--deviates",
                 never_judged, "--within", "moment_ratio=4:8", "--cases", "2000"});
  EXPECT_EQ(result.exit_status, 0) << result.output;
}

}  // namespace
}  // namespace carom::tests
