// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/properties/phenomena/phenomenon.hpp>
#include <carom/report/pages/time_pages.hpp>
#include <carom/report/pictures/time_pictures.hpp>
#include <carom/report/results/words.hpp>
#include <carom/subjects/protocol/exec_stepper.hpp>
#include <carom/subjects/steppers.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/gnuplot.hpp"
#include "io/interrupt.hpp"
#include "io/output.hpp"
#include "io/this_environment.hpp"
#include "io/usage_error.hpp"
#include "scene/scene_stepper.hpp"

namespace carom::tool {
namespace {

struct TimeArguments {
  std::vector<std::string> subjects;
  std::vector<std::string> phenomena;
  std::vector<std::string> steps;  // "1/60" or "0.01"
  bool is_quick = false;
  double timeout = 60;  // for each reply of a program [s]
  std::string out;      // directory; empty for none
  std::string pages;    // directory of the phenomena's pages; empty for none
  std::string format = "text";
};

/// Throws UsageError.
properties::Ladder ladder_of(const TimeArguments& arguments) {
  properties::Ladder ladder = arguments.is_quick ? properties::quick_ladder() : properties::full_ladder();
  std::set<double, std::greater<>> steps;
  for (const std::string& text : arguments.steps) {
    const std::optional<double> step = properties::step_from(text);
    if (!step) {
      throw UsageError(
          report::shown(fmt::format("--steps: expected a number of seconds from {} to {}, such as 1/60, found {}",
                                    properties::least_step, properties::greatest_step, text)));
    }
    steps.insert(*step);
  }
  if (!steps.empty()) {
    ladder.steps.assign(steps.begin(), steps.end());
  }
  return ladder;
}

/// The name of the relations, which have no known answer, beside those of the phenomena.
constexpr const char* heap = "heap";

std::vector<std::string> known_phenomena() {
  std::vector<std::string> known = properties::phenomenon_names();
  known.emplace_back(heap);
  return known;
}

/// The phenomena to measure.
struct Choice {
  std::vector<const properties::Phenomenon*> phenomena;
  bool has_relations = false;
};

/// The phenomena and relations that were named, all if none was. Throws UsageError if there is no phenomenon of a name.
Choice choice_of(const TimeArguments& arguments) {
  const std::vector<std::string> known = known_phenomena();
  const std::vector<std::string>& names = arguments.phenomena.empty() ? known : arguments.phenomena;
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw UsageError(report::shown(
          fmt::format("--phenomena: no phenomenon is named {}; there are {}", name, fmt::join(known, ", "))));
    }
  }
  const auto is_named = [&](std::string_view one) { return std::find(names.begin(), names.end(), one) != names.end(); };
  Choice choice{{}, is_named(heap)};
  for (const properties::Phenomenon& one : properties::all_phenomena()) {
    if (is_named(one.name)) {
      choice.phenomena.push_back(&one);
    }
  }
  return choice;
}

/// The engines that were named, all of them if none was. Throws UsageError if there is none of a name.
std::vector<Stepper> chosen_engines(const TimeArguments& arguments, const std::stop_token& stop) {
  const subjects::protocol::ExecOptions options = subjects::protocol::exec_options(arguments.timeout, stop);
  std::vector<Stepper> all = subjects::all_steppers();
  all.push_back(scene_stepper());
  std::vector<std::string> known;
  std::transform(all.begin(), all.end(), std::back_inserter(known), [](const Stepper& one) { return one.name; });
  const std::vector<std::string>& names = arguments.subjects.empty() ? known : arguments.subjects;
  std::vector<Stepper> chosen;
  for (const std::string& name : names) {
    const auto place = std::find(known.begin(), known.end(), name) - known.begin();
    if (std::count(names.begin(), names.end(), name) > 1) {
      throw UsageError(report::shown(fmt::format("the engine {} is named twice", name)));
    }
    if (name.starts_with(subjects::protocol::exec_prefix)) {
      chosen.push_back(subjects::protocol::exec_stepper(name, options));
    } else if (static_cast<std::size_t>(place) < all.size()) {
      chosen.push_back(subjects::started(all[static_cast<std::size_t>(place)], options));
    } else {
      throw UsageError(report::shown(
          fmt::format("no engine in time is named {}; there are {}, and 'exec:PROGRAM ARG…' for a program", name,
                      fmt::join(known, ", "))));
    }
  }
  return chosen;
}

/// `on_failure` is called with the first failure alone.
report::TimedEngine measured(const Stepper& stepper, const Choice& choice, const properties::Ladder& ladder,
                             const std::stop_token& stop, const std::function<void()>& on_phenomenon,
                             const std::function<void(const std::string& what)>& on_failure) {
  report::TimedEngine engine{stepper.name, stepper.version, stepper.precision, stepper.absent};
  engine.specification = stepper.specification;
  if (!engine.absent.empty()) {
    return engine;
  }
  const auto start = std::chrono::steady_clock::now();
  std::string_view asked = heap;
  bool has_failed = false;
  Stepper::Session session = properties::patient(stepper.open(), stop, [&](const std::string& why) {
    if (!std::exchange(has_failed, true)) {
      on_failure(fmt::format("{}, {}: {}", stepper.name, asked, why));
    }
  });
  for (const properties::Phenomenon* const phenomenon : choice.phenomena) {
    if (stop.stop_requested()) {
      break;
    }
    asked = phenomenon->name;
    engine.measurements.push_back(properties::measure(*phenomenon, stepper, session, ladder));
    on_phenomenon();
  }
  if (choice.has_relations && !stop.stop_requested()) {
    asked = heap;
    engine.relations = properties::heap_relations(stepper, session, report::compared_step(ladder));
  }
  for (const std::string& text : stepper.claims) {
    const properties::TimeClaim claim = properties::time_claim_from(text);
    const properties::Measurement* const of_claim = measurement_of(engine, claim.phenomenon);
    const std::string unjudged = of_claim == nullptr     ? claim.phenomenon + " was not measured"
                                 : stop.stop_requested() ? "the measurement was interrupted"
                                                         : "";
    engine.claims.push_back(
        {text, unjudged.empty() ? verdict_of(claim, *of_claim) : properties::ClaimVerdict{false, 0, unjudged},
         unjudged.empty()});
  }
  engine.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return engine;
}

/// Measures two engines at once. More would disturb each other's times on a small machine.
report::TimeRun measured(const std::vector<Stepper>& engines, bool are_named, const Choice& choice,
                         const properties::Ladder& ladder, const std::stop_token& stop) {
  report::TimeRun run{this_environment(), ladder, std::vector<report::TimedEngine>(engines.size()), are_named, false};
  const auto progress = progress_line("phenomena measured");
  std::uint64_t done = 0;
  std::mutex one_at_a_time;
  const auto on_phenomenon = [&] {
    const std::lock_guard lock(one_at_a_time);
    ++done;
    if (progress) {
      progress(done, choice.phenomena.size() * engines.size());
    }
  };
  const auto on_failure = [&](const std::string& what) {
    const std::lock_guard lock(one_at_a_time);
    fmt::print(stderr, "{}carom: {}\n", progress ? "\n" : "", report::shown(what));
  };
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < engines.size(); i = next++) {
      run.engines[i] = measured(engines[i], choice, ladder, stop, on_phenomenon, on_failure);
    }
  };
  std::future<void> other = std::async(std::launch::async, work);
  work();
  other.get();
  run.interrupted = stop.stop_requested();
  return run;
}

/// Draws the pictures into the directory. Without gnuplot there are no pictures, and the rest is written.
void draw_pictures(const report::TimeRun& run, const std::filesystem::path& directory) {
  std::vector<report::Plot> pictures = first_bounce_picture(run);
  for (const properties::Phenomenon& phenomenon : properties::all_phenomena()) {
    for (report::Plot& picture : time_pictures(phenomenon, run)) {
      pictures.push_back(std::move(picture));
    }
  }
  if (const std::exception_ptr error = try_to_draw(pictures, directory)) {
    try {
      std::rethrow_exception(error);
    } catch (const UsageError& why) {
      fmt::print(stderr, "carom: no pictures: {}\n", why.what());
    }
  }
}

void write_reports(const report::TimeRun& run, const TimeArguments& arguments, const Choice& choice,
                   std::optional<StagedOutput>& staged) {
  const std::string record = time_record(run).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  write_output(arguments.format == "json" ? record : time_text(run));
  if (staged) {
    draw_pictures(run, staged->stage());
    write_file(staged->stage() / "time.json", record);
    write_file(staged->stage() / "junit.xml", time_junit(run));
    write_file(staged->stage() / "report.html", time_html(run));
    staged->put_in_place("report.html");
  }
  for (const properties::Phenomenon* const one : choice.phenomena) {
    if (!arguments.pages.empty()) {
      write_file(std::filesystem::path(arguments.pages) / fmt::format("{}.md", one->name), phenomenon_page(*one, run),
                 "--pages");
    }
  }
}

/// Throws UsageError for a text that is no claim.
void read_claims(const Stepper& engine) try {
  std::for_each(engine.claims.begin(), engine.claims.end(), properties::time_claim_from);
} catch (const std::invalid_argument& error) {
  throw UsageError(report::shown(fmt::format("{}: time_claims: {}", engine.name, error.what())));
}

int measure_in_time(const TimeArguments& arguments) {
  const std::stop_token stop = stop_on_interrupt();
  const properties::Ladder ladder = ladder_of(arguments);
  const Choice choice = choice_of(arguments);
  const std::vector<Stepper> engines = chosen_engines(arguments, stop);
  std::for_each(engines.begin(), engines.end(), read_claims);
  std::optional<StagedOutput> staged;  // the directories are made before the measurement, which may take minutes
  if (!arguments.out.empty()) {
    staged.emplace(arguments.out);
  }
  if (!arguments.pages.empty()) {
    make_directories(arguments.pages, "--pages");
  }
  const auto run_of = [&](const Choice& what, const properties::Ladder& steps) {
    return measured(engines, !arguments.subjects.empty(), what, steps, stop);
  };
  if (!arguments.is_quick && arguments.steps.empty() && arguments.format == "text" && !choice.phenomena.empty()) {
    const report::TimeRun first = run_of({choice.phenomena, false}, properties::quick_ladder());
    if (first.interrupted) {
      write_reports(first, arguments, choice, staged);
      return report::exit_usage;
    }
    write_output("A first pass, as by --quick:\n\n" + time_summary(first) + "\nAll steps and phases:\n\n");
  }
  const report::TimeRun run = run_of(choice, ladder);
  write_reports(run, arguments, choice, staged);
  return run.exit_status();
}

}  // namespace

void add_time(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<TimeArguments>();
  CLI::App* command = app.add_subcommand("time",
                                         "Measure engines that step in time against ten phenomena with known answers; "
                                         "exit status 0 measured, 1 a claim is "
                                         "not kept, 2 usage or environment error, or nothing measured or judged");
  command->add_option(
      "SUBJECT", arguments->subjects,
      "A built-in engine, or 'exec:PROGRAM ARG…' for a program that answers `run` (default: all engines)");
  command
      ->add_option("--phenomena", arguments->phenomena,
                   fmt::format("Some of {} (default: all)", fmt::join(known_phenomena(), ", ")))
      ->delimiter(',')
      ->type_name("NAMES");
  command
      ->add_option("--steps", arguments->steps,
                   "Steps in seconds from 1/100000 to 1/10, such as 1/60,1/240 (default: 1/30 to 1/3840)")
      ->delimiter(',')
      ->type_name("STEPS");
  command->add_flag("--quick", arguments->is_quick, "Two steps and six phases: some seconds for an engine");
  command->add_option("--out", arguments->out, "Directory for report.html, time.json, junit.xml and pictures")
      ->type_name("DIR");
  command->add_option("--pages", arguments->pages, "Directory for a page in Markdown for each phenomenon")
      ->type_name("DIR");
  add_timeout(*command, arguments->timeout);
  add_format(*command, arguments->format, {"text", "json"});
  command->callback([&chosen, arguments] { chosen = [arguments] { return measure_in_time(*arguments); }; });
}

}  // namespace carom::tool
