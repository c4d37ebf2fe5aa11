// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/oracles/judge/yardstick.hpp>
#include <carom/properties/trial/nearest_name.hpp>
#include <carom/report/chart/chart_records.hpp>
#include <carom/report/chart/diagrams.hpp>
#include <carom/subjects/methods.hpp>

#include "chart/exactness.hpp"
#include "chart/timing.hpp"
#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/gnuplot.hpp"
#include "io/output_file.hpp"
#include "io/progress.hpp"
#include "io/staged_output.hpp"
#include "io/this_environment.hpp"
#include "io/threads.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

struct ChartArguments {
  std::vector<std::string> methods;  // names; empty for all
  std::string out;                   // a directory
  std::uint64_t seed = 1;
  std::size_t cases = 200;  // of each family, and at each point of a sweep
  int repetitions = 5;      // of each timing
  unsigned jobs = 0;        // threads that judge; 0: one for each core
};

using report::Exactness;
using report::MethodMeasurement;
using subjects::Method;

std::vector<Method> methods_of(const std::vector<std::string>& names) {
  std::vector<Method> all = subjects::methods();
  if (names.empty()) {
    return all;
  }
  std::vector<Method> chosen;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Method& m) { return m.subject.name == name; });
    if (found == all.end()) {
      std::vector<std::string> known;
      for (const Method& method : all) {
        known.push_back(method.subject.name);
      }
      throw UsageError(fmt::format("METHOD: there is no method '{}'; expected one of {}{}", name,
                                   fmt::join(known, ", "), properties::did_you_mean(name, known)));
    }
    chosen.push_back(*found);
  }
  return chosen;
}

struct FamilyCases {
  const properties::Family* family;
  std::vector<Collision> collisions;
};

std::vector<FamilyCases> families_of(const ChartArguments& arguments) {
  std::vector<FamilyCases> families;
  for (const properties::Family& family : properties::all_families()) {
    std::vector<Collision> collisions = chart::colliding_cases(family, arguments.seed, arguments.cases);
    if (!collisions.empty()) {
      families.push_back({&family, std::move(collisions)});
    }
  }
  return families;
}

std::vector<MethodMeasurement> measured_methods(const ChartArguments& arguments, const std::vector<Method>& methods,
                                                const properties::Workers& workers) {
  const std::vector<FamilyCases> families = families_of(arguments);
  // The timings come first, while nothing else runs.
  std::vector<chart::TimedKernel> kernels;
  for (const Method& method : methods) {
    for (const FamilyCases& family : families) {
      kernels.push_back({&method, family.collisions});
    }
  }
  const std::vector<report::Spread> times =
      chart::measured_times(kernels, arguments.repetitions, progress_line("timings"));

  std::vector<MethodMeasurement> result;
  for (const Method& method : methods) {
    result.push_back({method.subject.name, method.subject.summary, method.subject.law, method.subject.precision, {}});
  }
  for (std::size_t f = 0; f < families.size(); ++f) {
    std::vector<Exactness> exactness = chart::measured_exactness(
        methods, families[f].collisions, oracles::default_limit_ulps, workers, chart::AnswersOfCoulomb::found);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      result[m].families.push_back(
          {std::string(families[f].family->name), std::move(exactness[m]), times[m * families.size() + f]});
    }
  }
  return result;
}

std::vector<report::SweepMeasurement> measured_sweeps(const ChartArguments& arguments,
                                                      const std::vector<Method>& methods,
                                                      const properties::Workers& workers) {
  const auto progress = progress_line("points of sweeps");
  std::uint64_t all = 0;
  for (const properties::Sweep& sweep : properties::all_sweeps()) {
    all += sweep.quantities().size();
  }
  std::uint64_t done = 0;
  std::vector<report::SweepMeasurement> result;
  for (const properties::Sweep& sweep : properties::all_sweeps()) {
    report::SweepMeasurement measurement{
        std::string(sweep.name), std::string(sweep.quantity), std::string(sweep.summary), {}};
    for (const Method& method : methods) {
      measurement.lines.push_back(
          {method.subject.name, method.subject.law, method.subject.precision, sweep.quantities(), {}});
    }
    for (const double quantity : sweep.quantities()) {
      const std::vector<Collision> collisions =
          chart::colliding_cases(sweep, quantity, arguments.seed, arguments.cases);
      const std::vector<Exactness> exactness = chart::measured_exactness(
          methods, collisions, oracles::default_limit_ulps, workers, chart::AnswersOfCoulomb::left_out);
      for (std::size_t m = 0; m < methods.size(); ++m) {
        measurement.lines[m].exactness.push_back(exactness[m]);
      }
      if (progress) {
        progress(++done, all);
      }
    }
    result.push_back(std::move(measurement));
  }
  return result;
}

std::vector<report::Plot> pictures_of(const report::Measurements& measurements) {
  std::vector<report::Plot> pictures;
  for (const Law law : report::charted_laws()) {
    const std::vector<MethodMeasurement> methods = report::of_law(measurements.methods, law);
    if (methods.empty()) {
      continue;
    }
    pictures.push_back(report::work_precision(methods));
    pictures.push_back(report::work_precision_of_families(methods));
    pictures.push_back(report::deadline(methods));
    if (!determines_outcome(law)) {
      continue;  // stability maps show backward errors
    }
    for (const report::SweepMeasurement& sweep : measurements.sweeps) {
      pictures.push_back(report::stability_map(sweep, law, measurements.limit_ulps));
    }
  }
  return pictures;
}

int chart_methods(const ChartArguments& arguments) {
  const std::vector<Method> methods = methods_of(arguments.methods);
  StagedOutput staged(arguments.out);
  const properties::Workers workers = threads(arguments.jobs);
  const report::Measurements measurements{this_environment(),
                                          arguments.seed,
                                          arguments.cases,
                                          arguments.repetitions,
                                          oracles::default_limit_ulps,
                                          measured_methods(arguments, methods, workers),
                                          measured_sweeps(arguments, methods, workers)};
  const std::string tables = report::tables_markdown(measurements);
  const std::filesystem::path& stage = staged.stage();
  write_file(stage / "tables.md", tables);
  write_file(stage / "work-precision.csv", report::work_precision_csv(measurements));
  write_file(stage / "stability.csv", report::stability_csv(measurements));
  write_file(stage / "deadline.csv", report::deadline_csv(measurements));
  write_file(stage / "chart.json", report::chart_record(measurements).dump(1) + '\n');
  // If gnuplot fails, the numbers are still written.
  const std::exception_ptr undrawn = try_to_draw(pictures_of(measurements), stage);
  staged.put_in_place("chart.json");
  remove_abandoned_stages(arguments.out);
  fmt::print("{}", tables);
  if (undrawn) {
    std::fflush(stdout);
    std::rethrow_exception(undrawn);
  }
  return exit_all_hold;
}

}  // namespace

void add_chart(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<ChartArguments>();
  CLI::App* command = app.add_subcommand(
      "chart", "Measure the speed and the accuracy of the built-in methods, and draw charts of them");
  command->add_option("METHOD", arguments->methods, "Methods to measure (default: all built-in methods)");
  command->add_option("--out", arguments->out, "Directory for the charts and the data")->required();
  add_seed(*command, arguments->seed, "Seed of the cases; the same seed gives the same cases");
  command
      ->add_option("--cases", arguments->cases, "Number of colliding cases of each family and of each point of a sweep")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--repetitions", arguments->repetitions, "Number of repetitions of each timing")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_jobs(*command, arguments->jobs, "Number of threads that judge");
  command->callback([&chosen, arguments] { chosen = [arguments] { return chart_methods(*arguments); }; });
}

}  // namespace carom::tool
