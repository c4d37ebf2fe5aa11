// SPDX-License-Identifier: BSL-1.0
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <carom/collision/json/text.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/results/version.hpp>
#include <carom/subjects/protocol/shortage.hpp>

#include "commands/commands.hpp"
#include "io/output.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

/// For each unexpected argument, a line with the command or option that the user may have meant.
std::string meant_words(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  std::vector<std::string> options;
  for (const CLI::Option* option : (chosen.empty() ? &app : chosen.front())->get_options()) {
    for (const std::string& name : option->get_lnames()) {
      options.push_back("--" + name);
    }
  }
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
  }
  std::string lines;
  for (const std::string& word : app.remaining(true)) {
    const bool is_option = word.starts_with("--");
    if (!is_option && !chosen.empty()) {
      continue;
    }
    if (const auto nearest = properties::nearest_name(word.substr(0, word.find('=')), is_option ? options : commands)) {
      lines += fmt::format("Did you mean '{}'?\n", *nearest);
    }
  }
  return lines;
}

constexpr const char* no_value = "expected a value, found an empty text; is a variable not set?";

/// Lets every option and every other word of the command refuse an empty text, such as the value of an unset variable.
void refuse_empty_texts(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    if (option->get_type_size() != 0) {
      option->check([](const std::string& text) { return text.empty() ? std::string(no_value) : std::string(); });
    }
  }
}

/// The option in the first word "--option="; empty if there is none. CLI11 would take the next word as its value.
std::string option_without_value(int argc, char** argv) {
  for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("--") && word.find('=') == word.size() - 1) {
      return word.substr(0, word.size() - 1);
    }
  }
  return "";
}

int run_command(int argc, char** argv, const std::vector<void (*)(CLI::App&, Chosen&)>& commands) {
  CLI::App app("Carom checks rigid-body collision impulses against exact arithmetic.", "carom");
  app.set_version_flag("--version", report::version);
  app.require_subcommand(0, 1);
  Chosen chosen;
  for (const auto add : commands) {
    add(app, chosen);
  }
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    refuse_empty_texts(*command);
  }
  if (const std::string option = option_without_value(argc, argv); !option.empty()) {
    throw UsageError(fmt::format("{}: {}", option, no_value));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    app.exit(error);
    std::fputs(meant_words(app).c_str(), stderr);
    return exit_usage;
  } catch (const CLI::ParseError& error) {
    std::ostringstream answer;  // to --help or --version
    const bool is_answered = app.exit(error, answer, std::cerr) == 0;
    fmt::print("{}", answer.str());
    flush_output();
    return is_answered ? exit_all_hold : exit_usage;
  }
  if (!chosen) {
    std::fputs(fmt::format("carom: no command is given; expected one of the subcommands below\n{}", app.help()).c_str(),
               stderr);
    return exit_usage;
  }
  const int status = chosen();
  flush_output();
  return status;
}

/// Prints an error message, without the control characters of foreign text in it. If the message cannot be written, the
/// exit status still reports the error.
void complain(const std::string& what) {
  constexpr std::size_t longest = 20'000;
  std::fputs(fmt::format("carom: {}\n", carom::printable(what, longest)).c_str(), stderr);
}

/// Lets a failed allocation end the program with a message. An exception would pass for a failure of a subject.
void end_when_memory_ends() {
  static const std::string message =
      fmt::format("carom: {}\n", subjects::protocol::shortage(std::make_error_code(std::errc::not_enough_memory)));
  std::set_new_handler([] {
    std::fputs(message.c_str(), stderr);
    _exit(exit_usage);
  });
}

/// Ends the process by SIGPIPE, as if the process did not ignore this signal. A shell with `pipefail` then reports an
/// error, because nobody read the verdict.
[[noreturn]] void end_by_closed_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  // A parent may have left the signal blocked.
  constexpr int as_killed_by_a_signal = 128;
  std::_Exit(as_killed_by_a_signal + SIGPIPE);
}

}  // namespace

int run_program(int argc, char** argv, const std::vector<void (*)(CLI::App&, Chosen&)>& commands) {
  // A failed write must not end a program that has reports to write and programs to stop.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    end_when_memory_ends();
    return run_command(argc, argv, commands);
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0 && error.code() == std::errc::broken_pipe) {
      end_by_closed_pipe();
    }
    const std::string short_resource = subjects::protocol::shortage(error.code());
    complain((std::ferror(stdout) != 0 ? "standard output: " : "") + std::string(error.what()) +
             (short_resource.empty() ? "" : "; " + short_resource));
  } catch (const oracles::JudgeError& error) {
    complain(properties::in_words(error));
  } catch (const std::exception& error) {
    complain(error.what());
  } catch (...) {
    complain("an unknown error ended the program");
  }
  return exit_usage;
}

}  // namespace carom::tool
