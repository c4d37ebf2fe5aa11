// SPDX-License-Identifier: BSL-1.0
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int parts = 4;

/// A shard of four parts, of a subject that violates invariants.
std::vector<std::string> shard_gate(const fs::path& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"gate",       "reflection-in-basis-double",
                                     "--families", "elastic",
                                     "--cases",    std::to_string(2000 * parts),
                                     "--shard",    "2/2",
                                     "--out",      out.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<std::string> journaled_gate(const fs::path& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = shard_gate(out, more);
  arguments.emplace_back("--journal");
  return arguments;
}

fs::path file_of_part(const fs::path& out, int part) {
  return out / "journal" / ("part-" + std::to_string(2 * part) + "-of-" + std::to_string(2 * parts) + ".json");
}

json report_in(const fs::path& out) {
  json report = json::parse(content_of(out / "report.json"));
  report.at("environment").erase("date");
  for (json& subject : report.at("subjects")) {
    subject.erase("nanoseconds_per_solve");
  }
  return report;
}

/// The witnesses' files, without the path of the report.
std::vector<json> witnesses_in(const fs::path& out) {
  std::vector<json> witnesses;
  const json report = report_in(out);
  for (const json& subject : report.at("subjects")) {
    for (const json& violation : subject.at("violations")) {
      witnesses.push_back(json::parse(content_of(out / violation.at("witness").get<std::string>())));
      witnesses.back().erase("replay");
    }
  }
  return witnesses;
}

/// Starts the journaled gate, sends the signal when the journal has two parts, and returns the exit status.
int status_after_signal(const fs::path& out, int signal) {
  const pid_t process = start_carom(journaled_gate(out, {"--jobs", "1"}));
  for (int tries = 0; tries < 6000 && !fs::exists(file_of_part(out, 2)); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(fs::exists(file_of_part(out, 2)));
  EXPECT_EQ(kill(process, signal), 0);
  return wait_for(process);
}

class Journal : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = new TemporaryDirectory();
    const RunResult result = run_carom(shard_gate(plain()));
    EXPECT_EQ(result.exit_status, 1) << result.errors;
  }

  static void TearDownTestSuite() {
    delete directory_;
    directory_ = nullptr;
  }

  /// The reports of the shard without a journal.
  [[nodiscard]] static fs::path plain() { return directory_->path() / "plain"; }

  /// The reports of a gate that was killed after some parts.
  [[nodiscard]] static fs::path killed(const std::string& name) {
    const fs::path out = directory_->path() / name;
    EXPECT_EQ(status_after_signal(out, SIGKILL), -1);
    EXPECT_FALSE(fs::exists(out / "report.json"));
    return out;
  }

  static void expect_report_of_plain(const fs::path& out) {
    EXPECT_EQ(report_in(out), report_in(plain())) << json::diff(report_in(plain()), report_in(out)).dump(1);
    EXPECT_FALSE(witnesses_in(plain()).empty());
    EXPECT_EQ(witnesses_in(out), witnesses_in(plain()));
    EXPECT_FALSE(fs::exists(out / "journal"));
  }

  static void expect_refused(const RunResult& result, const std::string& message) {
    EXPECT_EQ(result.exit_status, 2);
    EXPECT_NE(result.errors.find(message), std::string::npos) << result.errors;
  }

 private:
  static inline TemporaryDirectory* directory_ = nullptr;
};

TEST_F(Journal, ChangesNoReport) {
  const TemporaryDirectory out;
  const RunResult result = run_carom(journaled_gate(out.path()));
  EXPECT_EQ(result.exit_status, 1) << result.errors;
  EXPECT_EQ(result.errors, "");
  expect_report_of_plain(out.path());
}

TEST_F(Journal, KeepsWhatAKilledShardFound) {
  const fs::path out = killed("killed");
  const RunResult result = run_carom(journaled_gate(out));
  EXPECT_EQ(result.exit_status, 1) << result.errors;
  EXPECT_NE(result.errors.find(" of 4 parts are in the journal, and are not judged again"), std::string::npos)
      << result.errors;
  expect_report_of_plain(out);
  for (const fs::directory_entry& entry : fs::directory_iterator(out)) {
    EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
  }
}

TEST_F(Journal, IsReadInPlaceOfTheParts) {
  const fs::path out = killed("changed");
  json part = json::parse(content_of(file_of_part(out, 1)));
  json& cases = part.at("subjects").at(0).at("families").at(0).at("cases");
  cases = cases.get<int>() + 7;
  { std::ofstream(file_of_part(out, 1)) << part.dump(); }
  EXPECT_EQ(run_carom(journaled_gate(out)).exit_status, 1);
  EXPECT_EQ(report_in(out).at("subjects").at(0).at("cases").get<int>(),
            report_in(plain()).at("subjects").at(0).at("cases").get<int>() + 7);
}

TEST_F(Journal, StaysAfterARequestToStop) {
  const TemporaryDirectory out;
  EXPECT_EQ(status_after_signal(out.path(), SIGTERM), 2);
  const json interrupted = report_in(out.path());
  EXPECT_TRUE(interrupted.at("interrupted").get<bool>());
  EXPECT_GE(interrupted.at("subjects").at(0).at("cases").get<int>(), 2000);
  EXPECT_FALSE(interrupted.at("subjects").at(0).at("violations").empty());
  EXPECT_TRUE(fs::exists(file_of_part(out.path(), 2)));
  EXPECT_EQ(run_carom(journaled_gate(out.path())).exit_status, 1);
  expect_report_of_plain(out.path());
}

TEST_F(Journal, RefusesPartsOfAnotherRun) {
  const fs::path out = killed("other");
  expect_refused(run_carom(journaled_gate(out, {"--seed", "2"})),
                 "part-2-of-8.json belongs to another run: seed: 1, but here 2; remove the folder, or choose another "
                 "--out");
  expect_refused(run_carom(journaled_gate(out, {"--deviates", "energy"})), "deviates: , but here energy");
  std::vector<std::string> more_cases = journaled_gate(out);
  more_cases[5] = "16000";
  expect_refused(run_carom(more_cases), "belongs to another run: it is not one of 16 parts");
  fs::copy_file(file_of_part(out, 1), file_of_part(out, 2), fs::copy_options::overwrite_existing);
  expect_refused(run_carom(journaled_gate(out)), "part-4-of-8.json: /shard/number: expected 4, found 2");
  { std::ofstream(file_of_part(out, 1)) << "{"; }
  expect_refused(run_carom(journaled_gate(out)), "part-2-of-8.json: ");
  fs::remove_all(out / "journal");
  EXPECT_EQ(run_carom(journaled_gate(out)).exit_status, 1);
  expect_report_of_plain(out);
}

TEST(AutomaticShard, HasItsOwnFolder) {
  const TemporaryDirectory out;
  std::vector<std::string> arguments{"OMPI_COMM_WORLD_RANK=1",
                                     "OMPI_COMM_WORLD_SIZE=3",
                                     carom_program(),
                                     "gate",
                                     "frictionless-double",
                                     "--families",
                                     "head_on",
                                     "--cases",
                                     "30",
                                     "--shard",
                                     "auto",
                                     "--out",
                                     out.path().string()};
  const RunResult result = run_program("/usr/bin/env", arguments);
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  const json shard = json::parse(content_of(out.path() / "shard-2-of-3" / "report.json")).at("shard");
  EXPECT_EQ(shard.at("number"), 2);
  EXPECT_EQ(shard.at("of"), 3);
  EXPECT_FALSE(fs::exists(out.path() / "report.json"));
}

}  // namespace
}  // namespace carom::tests
