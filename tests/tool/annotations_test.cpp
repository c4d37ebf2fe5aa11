// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/program.hpp"

namespace carom::tests {
namespace {

struct Command {
  std::string name;
  std::string title;
  std::string message;
};

std::string unescaped(std::string text) {
  for (const auto& [written, letter] :
       std::map<std::string, std::string>{{"%0A", "\n"}, {"%0D", "\r"}, {"%2C", ","}, {"%3A", ":"}}) {
    for (std::size_t at = text.find(written); at != std::string::npos; at = text.find(written)) {
      text.replace(at, written.size(), letter);
    }
  }
  for (std::size_t at = text.find("%25"); at != std::string::npos; at = text.find("%25", at + 1)) {
    text.replace(at, 3, "%");
  }
  return text;
}

/// GitHub's interpretation of a log. A line that begins with "::", after optional blanks, is a command, unless the log
/// has stopped commands.
std::vector<Command> commands_in(const std::string& log) {
  std::vector<Command> commands;
  std::string token;
  for (std::size_t begin = 0; begin < log.size();) {
    const std::size_t end = std::min(log.find('\n', begin), log.size());
    std::string line = log.substr(begin, end - begin);
    begin = end + 1;
    line.erase(0, std::min(line.find_first_not_of(" \t"), line.size()));
    const std::size_t second = line.find("::", 2);
    if (!line.starts_with("::") || second == std::string::npos) {
      continue;
    }
    std::string head = line.substr(2, second - 2);
    const std::string tail = line.substr(second + 2);
    if (!token.empty()) {
      token = head == token ? "" : token;
    } else if (head == "stop-commands") {
      token = tail;
    } else {
      const std::size_t blank = head.find(" title=");
      const std::string title = blank == std::string::npos ? "" : head.substr(blank + 7);
      EXPECT_EQ(title.find_first_of(",:"), std::string::npos) << line;
      commands.push_back({head.substr(0, blank), unescaped(title), unescaped(tail)});
    }
  }
  EXPECT_TRUE(token.empty()) << "commands are read again at the end";
  return commands;
}

std::vector<Command> commands_of(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--annotations", "github"});
  return commands_in(run_carom(arguments).output);
}

TEST(Annotations, AreAnErrorForEachViolationAndANoticeWithTheVerdict) {
  const TemporaryDirectory out;
  const std::vector<Command> commands =
      commands_of({"gate", "frictionless-double", "reflection-in-basis-double", "--families", "near_head_on",
                   "--deviates", few_families_judge_no, "--cases", "100", "--out", out.path().string()});
  ASSERT_GE(commands.size(), 3U);
  EXPECT_EQ(commands[0].name, "notice");
  EXPECT_EQ(commands[0].title, "diagnosis of reflection-in-basis-double");
  EXPECT_NE(commands[0].message.find("Look at: "), std::string::npos) << commands[0].message;
  for (std::size_t i = 1; i + 1 < commands.size(); ++i) {
    EXPECT_EQ(commands[i].name, "error");
    EXPECT_TRUE(commands[i].title.starts_with("reflection-in-basis-double violates ")) << commands[i].title;
    EXPECT_NE(commands[i].message.find("carom replay " + out.path().string()), std::string::npos);
  }
  const auto restitution = std::find_if(commands.begin(), commands.end(), [](const Command& command) {
    return command.title == "reflection-in-basis-double violates restitution";
  });
  ASSERT_NE(restitution, commands.end());
  EXPECT_NE(
      restitution->message.find("of 100 judged cases, most often in near_head_on. The normal velocity is reversed"),
      std::string::npos)
      << restitution->message;
  EXPECT_EQ(commands.back().name, "notice");
  EXPECT_EQ(commands.back().title, "carom: " + std::to_string(commands.size() - 2) + " violated");
  EXPECT_EQ(commands.back().message, "1 of 2 subjects that count are sound; 100 cases of each of 1 families, seed 1");
}

TEST(Annotations, OfWhatIsKnownFromTheBaselineAreNoErrors) {
  const TemporaryDirectory out;
  const std::vector<std::string> arguments{
      "gate", "reflection-in-basis-double", "--families", "near_head_on", "--cases", "100"};
  std::vector<std::string> before = arguments;
  before.insert(before.end(), {"--out", out.path().string()});
  EXPECT_EQ(run_carom(before).exit_status, 1);
  std::vector<std::string> after = arguments;
  after.insert(after.end(), {"--baseline", out.path().string()});
  const std::vector<Command> commands = commands_of(after);
  ASSERT_GE(commands.size(), 3U);
  for (const Command& command : commands) {
    EXPECT_EQ(command.name, "notice") << command.title;
  }
  EXPECT_NE(commands[1].title.find("known from the baseline"), std::string::npos) << commands[1].title;
  EXPECT_NE(commands.back().message.find("nothing new"), std::string::npos) << commands.back().message;
}

TEST(Annotations, LeaveOutWhatIsExpectedToFail) {
  const std::vector<Command> commands =
      commands_of({"gate", "--families", "near_head_on", "--deviates", few_families_judge_no, "--cases", "20"});
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(commands[0].title, "carom: sound");
}

TEST(Annotations, OfASubjectThatCannotBeJudgedSayWhy) {
  const std::vector<Command> escaped =
      commands_of({"gate", "exec:/no/such '100 %: a,b'", "--families", "head_on", "--cases", "2"});
  ASSERT_EQ(escaped.size(), 2U);
  EXPECT_EQ(escaped[0].title, "exec:/no/such '100 %: a,b' could not be judged");
  EXPECT_NE(escaped[0].message.find("/no/such"), std::string::npos);
  EXPECT_EQ(escaped[1].title, "carom: not judged");
  const RunResult result = run_carom({"gate", "exec:/no/such", "--families", "head_on", "--cases", "2"});
  EXPECT_NE(result.output.find("could not be judged at all"), std::string::npos) << result.output;
}

TEST(Annotations, AreNeverWhatASubjectWrites) {
  const TemporaryDirectory directory;
  const std::string program =
      directory.write("program.sh", "printf 'a line\\n::error title=planted::\\n' >&2; exit 3\n");
  const RunResult result =
      run_carom({"gate", "exec:sh " + program, "--families", "head_on", "--cases", "2", "--annotations", "github"});
  ASSERT_NE(result.output.find(" ::error title=planted::\n"), std::string::npos) << "it is printed as it stands";
  for (const Command& command : commands_in(result.output)) {
    EXPECT_NE(command.title, "planted");
  }
}

TEST(Annotations, DoNotGoWithJson) {
  const RunResult result =
      run_carom({"gate", "frictionless-double", "--annotations", "github", "--format", "json", "--cases", "1"});
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_NE(result.errors.find("--annotations"), std::string::npos) << result.errors;
  EXPECT_EQ(run_carom({"gate", "--annotations", "nobody"}).exit_status, 2);
}

}  // namespace
}  // namespace carom::tests
