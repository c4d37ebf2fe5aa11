// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <vector>

#include <carom/report/results/run.hpp>

namespace CLI {
class App;
}  // namespace CLI

/// The commands of the program, one file each, with their options, actions and exit statuses.
namespace carom::tool {

using report::exit_all_hold;
using report::exit_usage;
using report::exit_violated;

/// The command that the command line names. It writes to standard output and returns the exit status.
using Chosen = std::function<int()>;

/// Each function adds a command, which sets `chosen` if the command line names it. Precondition: `chosen` outlives
/// `app`.
void add_gate(CLI::App& app, Chosen& chosen);
void add_check(CLI::App& app, Chosen& chosen);  // of recorded collisions
void add_domain(CLI::App& app, Chosen& chosen);
void add_lists(CLI::App& app, Chosen& chosen);  // subjects, invariants, families, features
void add_chart(CLI::App& app, Chosen& chosen);
void add_plan(CLI::App& app, Chosen& chosen);  // of collisions; refuses scenes
void add_compare(CLI::App& app, Chosen& chosen);
void add_merge(CLI::App& app, Chosen& chosen);
void add_replay(CLI::App& app, Chosen& chosen);
void add_scene(CLI::App& app, Chosen& chosen);           // of the program carom-scene
void add_plan_of_scenes(CLI::App& app, Chosen& chosen);  // of carom-scene; of collisions, too
void add_time(CLI::App& app, Chosen& chosen);            // of carom-scene
void add_missing_scene(CLI::App& app, Chosen& chosen);   // of carom without carom-scene; throws UsageError
void add_missing_time(CLI::App& app, Chosen& chosen);    // likewise

/// Runs a program with these commands and returns its exit status, even if a command throws. Errors are reported on
/// standard error. If the reader of standard output is gone, the function ends the program by SIGPIPE.
[[nodiscard]] int run_program(int argc, char** argv, const std::vector<void (*)(CLI::App&, Chosen&)>& commands);

}  // namespace carom::tool
