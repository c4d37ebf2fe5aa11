// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <carom/collision/model.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/properties/trial/nearest_name.hpp>
#include <carom/subjects/protocol/text.hpp>

#include "commands/commands.hpp"
#include "commands/duration.hpp"
#include "commands/memory_reserve.hpp"
#include "version.hpp"

namespace {

using carom::tool::GateArguments;
using carom::tool::ReplayArguments;

// Below, no arithmetic passes; above, everything does.
constexpr double smallest_limit = 1e-3;
constexpr double largest_limit = 1e15;
constexpr double shortest_timeout = 1e-3;  // [s]
constexpr double longest_timeout = 86400;  // [s]

/// CLI11 wraps what does not fit into 64 bits, and minus signs.
std::string is_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  return error == std::errc() && end == text.data() + text.size() ? std::string()
                                                                  : "expected an integer from 0 to 2^64 - 1";
}

std::string is_duration(const std::string& text) {
  return carom::tool::duration_from(text) ? std::string() : std::string("expected ") + carom::tool::duration_form;
}

/// "2/3"; none where it is not one of so many.
std::optional<carom::properties::Shard> shard_from(std::string_view text) {
  constexpr std::uint64_t most = 1'000'000;
  carom::properties::Shard shard;
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto is_read = [](std::string_view digits, std::uint64_t& number) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return error == std::errc() && end == digits.data() + digits.size();
  };
  const bool is_shard = slash < text.size() && is_read(text.substr(0, slash), shard.number) &&
                        is_read(text.substr(slash + 1), shard.of) && shard.number >= 1 && shard.number <= shard.of &&
                        shard.of <= most;
  return is_shard ? std::optional(shard) : std::nullopt;
}

std::string is_shard(const std::string& text) {
  return shard_from(text) ? std::string() : std::string("expected I/N, I from 1 to N, N at most 1000000");
}

template <class Arguments>
void add_accuracy(CLI::App& command, Arguments& arguments, const std::string& of_limit, const std::string& of_digits) {
  arguments.limit_ulps = carom::oracles::default_limit_ulps;
  CLI::Option* limit_ulps = command.add_option("--limit-ulps", arguments.limit_ulps, of_limit);
  limit_ulps
      ->check([](const std::string& text) {
        // CLI::Range lets NaN pass.
        const double limit = std::strtod(text.c_str(), nullptr);
        return limit >= smallest_limit && limit <= largest_limit
                   ? std::string()
                   : fmt::format("expected a number from {} to {}", smallest_limit, largest_limit);
      })
      ->capture_default_str();
  command.add_option("--digits", arguments.digits, of_digits)->check(CLI::Range(1, 18))->excludes(limit_ulps);
}

template <class Arguments>
void add_yardstick(CLI::App& command, Arguments& arguments) {
  add_accuracy(command, arguments, "Largest backward error that passes, in ulps",
               "Pass what is right to so many digits, in place of ulps");
  command.add_flag(
      "--exact", arguments.exact,
      "Judge in exact arithmetic alone, without the filter that decides most verdicts sooner: the verdicts "
      "are the same");
}

template <class Arguments>
void add_timeout(CLI::App& command, Arguments& arguments) {
  command.add_option("--timeout", arguments.timeout, "Seconds that an exec: subject may take for each reply")
      ->check([](const std::string& text) {
        const double seconds = std::strtod(text.c_str(), nullptr);
        return seconds >= shortest_timeout && seconds <= longest_timeout
                   ? std::string()
                   : fmt::format("expected a number from {} to {}", shortest_timeout, longest_timeout);
      })
      ->capture_default_str();
}

void add_format(CLI::App& command, std::string& format, std::vector<std::string> formats) {
  command.add_option("--format", format, "Form of the output")
      ->check(CLI::IsMember(std::move(formats)))
      ->capture_default_str();
}

/// Of what was not expected, the command or the option that may have been meant; a line each.
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
    if (const auto nearest =
            carom::properties::nearest_name(word.substr(0, word.find('=')), is_option ? options : commands)) {
      lines += fmt::format("Did you mean '{}'?\n", *nearest);
    }
  }
  return lines;
}

/// What the command line asks for: the exit status.
int run_command(int argc, char** argv) {
  CLI::App app("Carom judges rigid-body collision impulses against exact arithmetic.", "carom");
  app.set_version_flag("--version", carom::tool::version);
  app.require_subcommand(0, 1);
  std::function<int()> run;

  GateArguments gate;
  CLI::App* gate_command = app.add_subcommand(
      "gate", "Judge subjects: exit status 0 all hold, 1 something violated, 2 usage or environment");
  gate_command->add_option("SUBJECT", gate.subjects,
                           "Subjects to judge, built-in names or 'exec:PROGRAM ARG…' for a program that speaks the "
                           "protocol (default: all built-ins; those expected to fail do not count)");
  gate_command->add_flag("--engines", gate.engines, "Judge every engine that is installed");
  gate_command->add_option("--seed", gate.seed, "The same seed gives the same cases")
      ->check(is_seed)
      ->capture_default_str();
  CLI::Option* cases = gate_command->add_option("--cases", gate.cases, "Cases of each family, times its weight")
                           ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}))
                           ->capture_default_str();
  gate_command
      ->add_option_function<std::string>(
          "--budget", [&gate](const std::string& text) { gate.budget = carom::tool::duration_from(text); },
          "Time to judge for, in place of --cases: 500ms, 10s, 2m or 1h. Families are drawn from in turn, those first "
          "that find most soonest; what was judged is reported. Shrinking what was found comes on top")
      ->check(is_duration)
      ->type_name("DURATION")
      ->excludes(cases);
  gate_command->add_flag("--fail-fast", gate.fail_fast,
                         "Ask a subject nothing more once it has violated an invariant. The run ends where this holds "
                         "of every subject, or there are no more cases; of each subject the first violation is "
                         "reported, shrunk and written, the same with any --jobs");
  gate_command
      ->add_option("--relations-every", gate.relations_every,
                   "Judge each invariant that relates collisions on every Nth case, the next one on other cases "
                   "(default: 1; 4 for programs)")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}));
  gate_command->add_option("--families", gate.families, "Families to draw from, separated by commas (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false);
  gate_command->add_option(
      "--out", gate.out,
      "Directory for the reports and witnesses/; those that an earlier report there lists are replaced");
  gate_command
      ->add_option(
          "--baseline", gate.baseline,
          "An earlier report.json, or the directory that holds it: what it has violated is known, and the exit "
          "status is 0 where nothing is new")
      ->excludes("--fail-fast");  // what comes first may be known, and hide what is new
  gate_command
      ->add_option_function<std::string>(
          "--shard", [&gate](const std::string& text) { gate.shard = shard_from(text); },
          "I/N: judge every Nth case of each family from the Ith on, a part of the run that carom merge makes one "
          "report of")
      ->check(is_shard)
      ->type_name("I/N")
      ->excludes("--budget")
      ->excludes("--fail-fast")
      ->excludes("--baseline");
  gate_command
      ->add_option("--deviates", gate.deviates,
                   "What no subject of this run claims, separated by commas: INVARIANT, or INVARIANT@FAMILY for one "
                   "family. It is not judged, and shown as not claimed")
      ->delimiter(',')
      ->allow_extra_args(false);
  gate_command
      ->add_option("--annotations", gate.annotations,
                   "Print what is violated as annotations too, in the form that this service shows beside a commit")
      ->check(CLI::IsMember({"github"}));
  gate_command->add_option("--summary", gate.summary, "File to whose end a summary in Markdown is added")
      ->type_name("FILE");
  gate_command->add_option("--jobs", gate.jobs, "Threads (default: one for each core)")->check(CLI::Range(1, 1024));
  add_yardstick(*gate_command, gate);
  add_timeout(*gate_command, gate);
  add_format(*gate_command, gate.format, {"text", "json"});
  gate_command->callback([&] { run = [&] { return carom::tool::gate(gate); }; });

  std::string subjects_format = "text";
  CLI::App* subjects_command = app.add_subcommand("subjects", "List the built-in subjects and engines");
  add_format(*subjects_command, subjects_format, {"text", "json"});
  subjects_command->callback([&] { run = [&] { return carom::tool::list_subjects(subjects_format); }; });

  std::string invariants_format = "text";
  CLI::App* invariants_command = app.add_subcommand("invariants", "Print the catalogue of invariants");
  add_format(*invariants_command, invariants_format, {"text", "markdown", "json"});
  invariants_command->callback([&] { run = [&] { return carom::tool::list_invariants(invariants_format); }; });

  std::string families_format = "text";
  std::uint64_t families_seed = 1;
  CLI::App* families_command = app.add_subcommand("families", "List the families, with an example of each");
  families_command->add_option("--seed", families_seed, "Seed of the examples")->check(is_seed)->capture_default_str();
  add_format(*families_command, families_format, {"text", "json"});
  families_command->callback([&] { run = [&] { return carom::tool::list_families(families_format, families_seed); }; });

  std::string features_format = "text";
  CLI::App* features_command = app.add_subcommand("features", "List the features that cases are composed of");
  add_format(*features_command, features_format, {"text", "markdown", "json"});
  features_command->callback([&] { run = [&] { return carom::tool::list_features(features_format); }; });

  carom::tool::ChartArguments chart;
  CLI::App* chart_command =
      app.add_subcommand("chart", "Measure speed and accuracy of the built-in methods and draw one against the other");
  chart_command->add_option("METHOD", chart.methods, "Methods to measure (default: every built-in one)");
  chart_command->add_option("--out", chart.out, "Directory for the pictures and the data")->required();
  chart_command->add_option("--seed", chart.seed, "The same seed gives the same cases")
      ->check(is_seed)
      ->capture_default_str();
  chart_command->add_option("--cases", chart.cases, "Colliding cases of each family and at each point of a sweep")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  chart_command->add_option("--repetitions", chart.repetitions, "Repetitions of each timing")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  chart_command->add_option("--jobs", chart.jobs, "Threads that judge (default: one for each core)")
      ->check(CLI::Range(1, 1024));
  chart_command->callback([&] { run = [&] { return carom::tool::chart_methods(chart); }; });

  carom::tool::SceneArguments scene;
  CLI::App* scene_command = app.add_subcommand(
      "scene", "Run a scene: every event in certified order, every impulse judged, every joule booked");
  scene_command->add_option("FILE", scene.file, "A scene (docs/reference/schemas/scene.schema.json)")->required();
  scene_command->add_option("--laws", scene.laws, "Laws to run it under, separated by commas (default: the scene's)")
      ->delimiter(',')
      ->allow_extra_args(false);
  scene_command->add_option("--out", scene.out, "Directory for events, series, pictures, report and replay");
  scene_command->add_option("--judge-every", scene.judge_every, "Judge every Nth impulse; 0: none")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1'000'000'000}))
      ->capture_default_str();
  scene_command->add_flag("!--no-check", scene.check, "Do not check that nothing overlaps");
  scene_command->add_option("--events", scene.events, "End the run after so many events")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000'000}));
  scene_command->add_option("--jobs", scene.jobs, "Laws that run at once (default: one for each core)")
      ->check(CLI::Range(1, 1024));
  add_format(*scene_command, scene.format, {"text", "json"});
  scene_command->callback([&] { run = [&] { return carom::tool::run_scene_file(scene); }; });

  carom::tool::PlanArguments plan;
  std::vector<std::string> laws;
  for (const carom::Model model : carom::all_models) {
    if (model != carom::Model::any) {
      laws.emplace_back(name_of(model));
    }
  }
  CLI::App* plan_command = app.add_subcommand(
      "plan",
      "The least law, precision, solve, frame and batch that serve the contacts of a file, certified on them: exit "
      "status 0 something serves, 1 nothing does, 2 usage or bad input");
  plan_command
      ->add_option("FILE", plan.file,
                   "A scene; or JSON Lines of collisions, or one, or an array; \"class\" names that of a contact")
      ->required();
  plan_command->add_option("--law", plan.law, "The law that is wanted (default: the scene's; of collisions, rough)")
      ->check(CLI::IsMember(laws));
  add_accuracy(*plan_command, plan, "Largest backward error that serves, in ulps of binary64",
               "So many correct digits of the change of the velocities serve, in place of ulps");
  plan_command->add_flag("--exact-law", plan.exact_law,
                         "A lesser law only where it is, exactly and on every contact, the one that is wanted");
  plan_command
      ->add_option("--repetitions", plan.repetitions,
                   "Repetitions of each timing; 0 times nothing, and law, precision and solve decide what is least")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  plan_command->add_option("--jobs", plan.jobs, "Threads that judge (default: one for each core)")
      ->check(CLI::Range(1, 1024));
  add_format(*plan_command, plan.format, {"text", "markdown", "json"});
  plan_command->callback([&] { run = [&] { return carom::tool::plan_contacts(plan); }; });

  carom::tool::CompareArguments comparison;
  CLI::App* compare_command = app.add_subcommand(
      "compare", "Compare two reports: exit status 0 nothing is new in the second, 1 something is, 2 bad input");
  compare_command
      ->add_option("OLD", comparison.before, "report.json of `carom gate --out`, or the directory that holds it")
      ->required();
  compare_command->add_option("NEW", comparison.now, "The later one")->required();
  add_format(*compare_command, comparison.format, {"text", "markdown", "html", "json"});
  compare_command->callback([&] { run = [&] { return carom::tool::compare_files(comparison); }; });

  carom::tool::MergeArguments merge;
  CLI::App* merge_command = app.add_subcommand(
      "merge",
      "Make one report of those of all shards of a run: exit status as of the whole run, 2 where they do not "
      "belong together");
  merge_command->add_option("DIRECTORY", merge.directories, "What `carom gate --shard I/N --out` wrote")->required();
  merge_command->add_option("--out", merge.out, "Directory for the reports and witnesses/")->required();
  merge_command->add_option("--baseline", merge.baseline, "An earlier report of the whole, as of carom gate");
  add_format(*merge_command, merge.format, {"text", "json"});
  merge_command->callback([&] { run = [&] { return carom::tool::merge_shards(merge); }; });

  std::string report_file;
  CLI::App* table_command = app.add_subcommand("table", "Print the subjects of a report.json as a Markdown table");
  table_command->add_option("FILE", report_file, "report.json of `carom gate --out`")->required();
  table_command->callback([&] { run = [&] { return carom::tool::table(report_file); }; });

  std::string badge_file;
  std::string badge_out;
  CLI::App* badge_command =
      app.add_subcommand("badge", "Write the verdict of a report.json as JSON for a badge of shields.io");
  badge_command->add_option("FILE", badge_file, "report.json of `carom gate --out`")->required();
  badge_command->add_option("--out", badge_out, "File to write (default: standard output)")->type_name("FILE");
  badge_command->callback([&] { run = [&] { return carom::tool::badge(badge_file, badge_out); }; });

  ReplayArguments replay;
  CLI::App* replay_command =
      app.add_subcommand("replay", "Show the exact truth of collisions, each step; judge a subject on them");
  CLI::Option* replayed_file =
      replay_command->add_option("FILE", replay.file, "A witness, a vector file, or JSON Lines of collisions");
  replay_command->add_flag("--drawn", replay.drawn, "Of a witness the collision that was drawn, before it was shrunk")
      ->needs(replayed_file);
  CLI::Option* replayed_family =
      replay_command->add_option("--family", replay.family, "In place of FILE: the family whose case is meant")
          ->excludes(replayed_file);
  CLI::Option* replayed_case =
      replay_command->add_option("--case", replay.case_number, "The number of that case, from 0")->check(is_seed);
  replayed_case->needs(replayed_family);
  replayed_family->needs(replayed_case);
  replay_command->add_option("--seed", replay.seed, "The seed that it is drawn with")
      ->check(is_seed)
      ->capture_default_str()
      ->needs(replayed_family);
  replay_command->add_option("--subject", replay.subject,
                             "Subject to judge (default: the one that a witness names, where that is no program)");
  add_yardstick(*replay_command, replay);
  add_timeout(*replay_command, replay);
  add_format(*replay_command, replay.format, {"text", "json"});
  replay_command->callback([&] {
    if (replay.file.empty() && replay.family.empty()) {
      throw CLI::RequiredError("FILE, or --family and --case");
    }
    run = [&] { return carom::tool::replay(replay); };
  });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    app.exit(error);
    std::fputs(meant_words(app).c_str(), stderr);
    return carom::tool::exit_usage;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : carom::tool::exit_usage;
  }
  if (!run) {
    std::fputs(fmt::format("carom: a command is needed\n{}", app.help()).c_str(), stderr);
    return carom::tool::exit_usage;
  }
  const int status = run();
  if (carom::tool::has_run_out_of_memory()) {
    std::fputs(carom::tool::out_of_memory, stderr);
    return carom::tool::exit_usage;
  }
  if (std::fflush(stdout) != 0) {
    throw carom::tool::UsageError("standard output cannot be written");
  }
  return status;
}

/// What is wrong may be told in words of a file or a program. Where it cannot be written, the exit status says it.
void complain(const std::string& what) {
  if (carom::tool::has_run_out_of_memory()) {
    std::fputs(carom::tool::out_of_memory, stderr);  // whatever came of it
    return;
  }
  constexpr std::size_t longest = 20'000;
  std::fputs(fmt::format("carom: {}\n", carom::subjects::protocol::printable(what, longest)).c_str(), stderr);
}

}  // namespace

int main(int argc, char** argv) {
  // Output that cannot be written is an error to tell, and not the end of a program that has reports to write.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run_command(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs(carom::tool::out_of_memory, stderr);
  } catch (const std::system_error& error) {
    complain((std::ferror(stdout) != 0 ? "standard output: " : "") + std::string(error.what()));
  } catch (const std::exception& error) {
    complain(error.what());
  } catch (...) {
    complain("ended by what is no exception");
  }
  return carom::tool::exit_usage;
}
