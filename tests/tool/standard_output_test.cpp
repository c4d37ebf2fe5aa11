// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/program.hpp"

namespace carom::tests {
namespace {

/// The exit status and the standard error of a command. The script breaks the standard output of the command.
std::string said_by(const std::string& script, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"-c", script + R"(; echo "status $?" >&2)", "sh", carom_program()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program("/bin/sh", words).errors;
}

const std::vector<std::vector<std::string>> commands{
    {"--version"},
    {"--help"},
    {"invariants"},
    {"features", "--format", "json"},
    {"gate", "frictionless-double", "--families", "head_on", "--cases", "2"},
    {"replay", std::string(CAROM_SOURCE_DIR) + "/docs/examples/head_on.json"},
};

/// As with other programs, `carom … | head -1` prints no error. The loop waits until the reader is gone.
TEST(StandardOutput, ThatNobodyReadsEndsTheProgramSilently) {
  const std::string broken = R"({ trap '' PIPE; while echo 2> /dev/null; do :; done; trap - PIPE; "$@"; status=$?
    echo "status $status" >&2; } | true)";
  for (const std::vector<std::string>& command : commands) {
    EXPECT_EQ(said_by(broken, command), "status 141\nstatus 0\n") << command[0];
  }
}

TEST(StandardOutput, ThatCannotBeWrittenIsAnError) {
  for (const std::vector<std::string>& command : commands) {
    const std::string said = said_by(R"("$@" > /dev/full)", command);
    EXPECT_TRUE(said.starts_with("carom: standard output")) << command[0] << ": " << said;
    EXPECT_TRUE(said.ends_with(": No space left on device\nstatus 2\n")) << command[0] << ": " << said;
  }
}

}  // namespace
}  // namespace carom::tests
