// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include <carom/report/results/run_json.hpp>
#include <carom/subjects/protocol/command_line.hpp>
#include <carom/subjects/protocol/shortage.hpp>

#include "io/interrupt.hpp"
#include "io/job_shard.hpp"
#include "io/this_environment.hpp"
#include "io/threads.hpp"
#include "io/usage_error.hpp"
#include "support/expect_in.hpp"
#include "support/message_of.hpp"
#include "support/program.hpp"

namespace carom::tool {
namespace {

using Variables = std::map<std::string, std::string>;

VariableLookup lookup_in(const Variables& variables) {
  return [&variables](const std::string& name) {
    const auto found = variables.find(name);
    return found == variables.end() ? std::nullopt : std::optional(found->second);
  };
}

std::pair<std::uint64_t, std::uint64_t> shard_in(const Variables& variables) {
  const properties::Shard shard = shard_of_job(lookup_in(variables));
  return {shard.number, shard.of};
}

Variables array_task(const std::string& id, const std::string& min, const std::string& max, const std::string& count) {
  return {{"SLURM_ARRAY_TASK_ID", id},
          {"SLURM_ARRAY_TASK_MIN", min},
          {"SLURM_ARRAY_TASK_MAX", max},
          {"SLURM_ARRAY_TASK_COUNT", count}};
}

Variables step_task(const std::string& task, const std::string& tasks) {
  return {{"SLURM_PROCID", task}, {"SLURM_STEP_NUM_TASKS", tasks}};
}

Variables rank(const std::string& number, const std::string& size) {
  return {{"OMPI_COMM_WORLD_RANK", number}, {"OMPI_COMM_WORLD_SIZE", size}};
}

Variables both(Variables first, const Variables& second) {
  first.insert(second.begin(), second.end());
  return first;
}

using Pair = std::pair<std::uint64_t, std::uint64_t>;

TEST(ShardArgument, IsANumberFromOneToTheNumberOfShards) {
  EXPECT_EQ(shard_from("2/3")->number, 2U);
  EXPECT_EQ(shard_from("1/1000000")->of, 1'000'000U);
  for (const char* bad :
       {"0/3", "4/3", "1", "/3", "1/", "1/0", "-1/3", "1/3/3", "1/3x", "1/1000001", "1/9999999999999999999999"}) {
    EXPECT_FALSE(shard_from(bad)) << bad;
  }
}

/// The last four rows set variables of two levels.
TEST(JobShard, IsThePlaceOfTheProcessAmongAllProcessesOfItsBatchSystem) {
  for (const auto& [variables, shard] : std::vector<std::pair<Variables, Pair>>{
           {array_task("1", "1", "10", "10"), {1, 10}},
           {array_task("9", "0", "9", "10"), {10, 10}},
           {array_task("9", "1", "13", "4"), {3, 4}},  // --array=1-15:4
           {array_task("7", "7", "7", "1"), {1, 1}},
           {{{"JOB_COMPLETION_INDEX", "4"}, {"JOB_COMPLETIONS", "5"}}, {5, 5}},
           {{{"STRATEGY_JOB_INDEX", "0"}, {"STRATEGY_JOB_TOTAL", "256"}}, {1, 256}},
           {{{"CI_NODE_INDEX", "3"}, {"CI_NODE_TOTAL", "3"}}, {3, 3}},
           {rank("1", "2"), {2, 2}},
           {step_task("0", "8"), {1, 8}},
           {both({{"CI_NODE_INDEX", "2"}, {"CI_NODE_TOTAL", "2"}}, rank("1", "3")), {5, 6}},
           {both(step_task("1", "2"), rank("5", "6")), {6, 6}},  // a daemon of mpirun is a step's task
           {both(array_task("2", "1", "2", "2"), {{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "4"}}), {2, 2}},  // no step
           {both(rank("0", "2"), {{"CI_NODE_TOTAL", "1"}}), {1, 2}},  // a job that is not parallel
       }) {
    EXPECT_EQ(shard_in(variables), shard) << testing::PrintToString(variables);
  }
}

TEST(JobShard, CountsEachProcessOfEachJobOnce) {
  std::vector<Pair> shards;
  std::vector<Pair> expected;
  for (int task = 1; task <= 3; ++task) {
    for (int process = 0; process < 4; ++process) {
      shards.push_back(
          shard_in(both(array_task(std::to_string(task), "1", "3", "3"), step_task(std::to_string(process), "4"))));
      expected.emplace_back(expected.size() + 1, 12);
    }
  }
  EXPECT_EQ(shards, expected);
}

TEST(JobShard, RefusesAMissingOrWrongVariableAndNamesItWithItsValue) {
  const std::vector<std::pair<Variables, std::string>> cases{
      {array_task("11", "1", "10", "10"), "SLURM_ARRAY_TASK_ID is 11; expected a number from 1 to 10"},
      {array_task("0", "1", "10", "10"), "SLURM_ARRAY_TASK_ID is 0; expected a number from 1 to 10"},
      {array_task("3", "1", "7", "3"), "SLURM_ARRAY_TASK_ID is 3, but SLURM_ARRAY_TASK_MIN is 1"},
      {array_task("3", "1", "8", "3"), "SLURM_ARRAY_TASK_COUNT is 3, but SLURM_ARRAY_TASK_MIN is 1"},
      {array_task("1", "1", "2", "1"), "SLURM_ARRAY_TASK_COUNT is 1, but"},
      {array_task("1", "1", "1", "2"), "SLURM_ARRAY_TASK_COUNT is 2, but"},
      {array_task("1", "1", "2", "0"), "SLURM_ARRAY_TASK_COUNT is 0; expected a number from 1 to 1000000"},
      {array_task("one", "1", "2", "2"), "SLURM_ARRAY_TASK_ID is 'one'; expected a number in decimal digits"},
      {{{"SLURM_ARRAY_TASK_ID", "1"}}, "SLURM_ARRAY_TASK_COUNT is not set"},
      {rank("2", "2"), "OMPI_COMM_WORLD_RANK is 2; expected a number from 0 to 1"},
      {rank("-1", "2"), "OMPI_COMM_WORLD_RANK is '-1'"},
      {rank("0", "99999999999999999999999"), "OMPI_COMM_WORLD_SIZE is '99999999999999999999999'"},
      {rank("0", "1000001"), "OMPI_COMM_WORLD_SIZE is 1000001; expected a number from 1 to 1000000"},
      {step_task("4", "4"), "SLURM_PROCID is 4; expected a number from 0 to 3, because SLURM_STEP_NUM_TASKS is 4"},
      {{{"SLURM_STEP_NUM_TASKS", "4"}}, "SLURM_PROCID is not set; srun sets both variables"},
      {{{"JOB_COMPLETION_INDEX", "0"}},
       "JOB_COMPLETIONS is not set; set JOB_COMPLETIONS to the job's spec.completions"},
      {{{"JOB_COMPLETION_INDEX", "5"}, {"JOB_COMPLETIONS", "5"}}, "JOB_COMPLETION_INDEX is 5"},
      {{{"STRATEGY_JOB_INDEX", "1"}}, "STRATEGY_JOB_TOTAL is not set; set both variables to strategy.job-index"},
      {{{"STRATEGY_JOB_INDEX", ""}, {"STRATEGY_JOB_TOTAL", "2"}}, "STRATEGY_JOB_INDEX is ''"},
      {{{"CI_NODE_INDEX", "0"}, {"CI_NODE_TOTAL", "2"}}, "CI_NODE_INDEX is 0; expected a number from 1 to 2"},
      {both(array_task("1", "1", "1000", "1000"), rank("0", "1001")),
       "1000 jobs with 1001 processes each are too many"},
      {both(array_task("1", "1", "2", "2"), {{"CI_NODE_INDEX", "1"}, {"CI_NODE_TOTAL", "2"}}),
       "both SLURM_ARRAY_TASK_ID and CI_NODE_INDEX are set"},
      {{{"CI_NODE_TOTAL", "1"}, {"SLURM_PROCID", "0"}}, "the environment has no variable of a batch system"},
  };
  for (const auto& [variables, message] : cases) {
    const std::string said = unit::message_of<UsageError>([&one = variables] { return shard_in(one); });
    EXPECT_TRUE(said.starts_with("--shard auto: ")) << said;
    unit::expect_in(said, {message});
  }
}

TEST(Threads, DoEachItemOnce) {
  for (const unsigned jobs : {0U, 1U, 3U, 40U}) {
    std::vector<std::atomic<int>> done(20);
    threads(jobs).run(done.size(), [&](std::size_t i) { ++done[i]; });
    for (const std::atomic<int>& one : done) {
      EXPECT_EQ(one, 1) << jobs;
    }
  }
}

TEST(Threads, PassOnAnExceptionAndBeginNoMoreItems) {
  for (const unsigned jobs : {1U, 3U}) {
    std::atomic<std::size_t> begun = 0;
    const auto work = [&](std::size_t i) {
      ++begun;
      if (i == 5) {
        throw std::runtime_error("the fifth");
      }
    };
    EXPECT_THROW(threads(jobs).run(1'000'000, work), std::runtime_error);
    EXPECT_LT(begun, 1'000'000U);
  }
}

/// Without the names of files, folders and definitions of the precompiled header.
std::multiset<std::string> flags_of(const std::vector<std::string>& words) {
  static const std::set<std::string> followed_by_a_name{"-o", "-c", "-isystem", "-include", "-Xclang"};
  std::multiset<std::string> flags;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (followed_by_a_name.contains(words[k])) {
      ++k;
    } else if (words[k].starts_with('-') && !words[k].starts_with("-I") && words[k] != "-Winvalid-pch") {
      flags.insert(words[k]);
    }
  }
  return flags;
}

/// Some files of a library have flags of their own, so one file must have the recorded ones.
TEST(Environment, RecordsTheFlagsThatEachLibraryWasCompiledWith) {
  if (!std::filesystem::exists(CAROM_COMPILE_COMMANDS)) {
    GTEST_SKIP() << "this generator writes no " << CAROM_COMPILE_COMMANDS;
  }
  const nlohmann::json commands = nlohmann::json::parse(tests::content_of(CAROM_COMPILE_COMMANDS));
  const report::Environment environment = this_environment();
  for (const auto& [library, flags] : environment.compiler_flags) {
    const std::multiset<std::string> recorded = flags_of(subjects::protocol::split_words(flags));
    const std::string folder = "/" + library + ".dir/";
    EXPECT_TRUE(std::any_of(commands.begin(), commands.end(),
                            [&](const nlohmann::json& entry) {
                              const auto command = entry.at("command").get<std::string>();
                              return command.find(folder) != std::string::npos &&
                                     flags_of(subjects::protocol::split_words(command)) == recorded;
                            }))
        << library << ": " << flags;
  }
  for (const char* library : {"carom_batch", "carom_collision_json", "carom_oracles", "carom_properties",
                              "carom_protocol", "carom_rational", "carom_subjects", "carom_tool"}) {
    EXPECT_TRUE(environment.compiler_flags.contains(library)) << library;
  }
}

using namespace std::chrono_literals;

bool is_requested_soon(const std::stop_token& stop) {
  for (int tries = 0; tries < 500 && !stop.stop_requested(); ++tries) {
    std::this_thread::sleep_for(10ms);
  }
  return stop.stop_requested();
}

/// Sends the signals that `timeout` sends: one to the program, one to its group (here the program again), and at last
/// SIGCONT.
[[noreturn]] void be_signalled_at_once() {
  const std::stop_token stop = stop_on_interrupt();
  kill(getpid(), SIGTERM);
  kill(getpid(), SIGINT);
  const bool requested = is_requested_soon(stop);
  kill(getpid(), SIGTERM);
  kill(getpid(), SIGCONT);
  std::this_thread::sleep_for(100ms);
  std::_Exit(requested ? 0 : 3);
}

[[noreturn]] void be_signalled_for_long() {
  const std::stop_token stop = stop_on_interrupt();
  for (int tries = 0; tries < 100; ++tries) {
    kill(getpid(), SIGTERM);
    std::this_thread::sleep_for(300ms);
  }
  std::_Exit(3);
}

/// As under nohup, which leaves SIGHUP ignored, or in the background of a script, where SIGINT is ignored.
[[noreturn]] void be_signalled_where_that_is_ignored(int signal) {
  std::signal(signal, SIG_IGN);
  const std::stop_token stop = stop_on_interrupt();
  kill(getpid(), signal);
  std::this_thread::sleep_for(100ms);
  const bool is_ignored = !stop.stop_requested();
  kill(getpid(), SIGTERM);
  std::_Exit(is_ignored && is_requested_soon(stop) ? 0 : 3);
}

/// As a user of whom no other thread may be started. The limit does not bind root.
[[noreturn]] void start_where_no_thread_may() {
  constexpr uid_t nobody = 65534;
  const rlimit one{1, 1};
  if (setrlimit(RLIMIT_NPROC, &one) != 0 || (geteuid() == 0 && setuid(nobody) != 0)) {
    std::_Exit(4);
  }
  try {
    (void)stop_on_interrupt();
  } catch (const std::system_error& error) {
    std::cerr << subjects::protocol::shortage(error.code());
    std::_Exit(0);
  }
  std::_Exit(3);
}

/// Sends SIGXCPU again and again, as the system does, for longer than all signals are one wish.
[[noreturn]] void use_up_processor_time() {
  const std::stop_token stop = stop_on_interrupt();
  for (const auto until = std::chrono::steady_clock::now() + 1500ms; std::chrono::steady_clock::now() < until;) {
    kill(getpid(), SIGXCPU);
    std::this_thread::sleep_for(20ms);
  }
  std::_Exit(stop.stop_requested() ? 0 : 3);
}

class InterruptDeathTest : public testing::Test {
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(InterruptDeathTest, TheLimitOnProcessorTimeRequestsOneStop) {
  EXPECT_EXIT(use_up_processor_time(), testing::ExitedWithCode(0), "");
}

TEST_F(InterruptDeathTest, ASignalThatTheParentLeftIgnoredIsIgnored) {
  for (const int signal : {SIGHUP, SIGINT}) {
    EXPECT_EXIT(be_signalled_where_that_is_ignored(signal), testing::ExitedWithCode(0), "") << signal;
  }
}

TEST_F(InterruptDeathTest, AShortageOfThreadsIsNamedWithItsLimit) {
  EXPECT_EXIT(start_where_no_thread_may(), testing::ExitedWithCode(0),
              "processes and threads are short: this user may have at most 1 \\(ulimit -u\\)");
}

TEST_F(InterruptDeathTest, SignalsWithinASecondRequestOneStopAndALaterOneEndsTheProgram) {
  EXPECT_EXIT(be_signalled_at_once(), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(be_signalled_for_long(), testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace carom::tool
