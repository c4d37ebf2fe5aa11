// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include <carom/oracles/judge/yardstick.hpp>
#include <carom/report/pages/chart_records.hpp>
#include <carom/report/pictures/diagrams.hpp>
#include <carom/report/results/words.hpp>
#include <carom/subjects/methods.hpp>

#include "commands/chart.hpp"
#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/gnuplot.hpp"
#include "io/interrupt.hpp"
#include "io/output.hpp"
#include "io/this_environment.hpp"
#include "io/threads.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

struct ChartArguments {
  std::vector<std::string> subjects;  // empty for all methods
  std::string out;                    // a directory
  std::uint64_t seed = 1;
  std::size_t cases = 200;  // of each family, and at each point of a sweep
  int repetitions = 5;      // of each timing
  unsigned jobs = 0;        // threads that judge; 0: one for each core
  double timeout = 5;       // for each reply of a program [s]
};

using report::Exactness;
using report::MethodMeasurement;
using subjects::Method;

/// A method has a kernel for the clock. Of any other subject, only the accuracy is charted.
struct Charted {
  std::vector<Method> methods;
  std::vector<Subject> others;
  std::stop_token stop;  // of an interrupt; without programs, an interrupt ends this process
};

Subject subject_with_map(const std::string& name, const ChartArguments& arguments, const std::stop_token& stop) {
  Subject subject = subject_from_argument(name, arguments.timeout, stop);
  if (!subject.absent.empty()) {
    throw UsageError(report::shown(fmt::format("{}: {}", subject.name, subject.absent)));
  }
  if (!determines_outcome(subject.law)) {
    try {
      subject.open().close();  // throws the reason if a program cannot be run
    } catch (const std::exception& error) {
      throw UsageError(report::shown(fmt::format("{}: {}", subject.name, error.what())));
    }
    throw UsageError(report::shown(
        fmt::format("{}: a chart shows errors against the law's outcome, and its law `{}` determines none",
                    subject.name, name_of(subject.law))));
  }
  return subject;
}

Charted charted_by(const ChartArguments& arguments) {
  Charted charted{subjects::methods(), {}, {}};
  if (arguments.subjects.empty()) {
    return charted;
  }
  const std::vector<Method> all = std::exchange(charted.methods, {});
  for (const std::string& name : arguments.subjects) {
    const auto method = std::ranges::find_if(all, [&](const Method& one) { return one.subject.name == name; });
    if (method != all.end()) {
      charted.methods.push_back(*method);
    } else {
      charted.stop = stop_on_interrupt();
      charted.others.push_back(subject_with_map(name, arguments, charted.stop));
    }
  }
  return charted;
}

/// The methods, and then the other subjects.
std::vector<Subject> subjects_of(const Charted& charted) {
  std::vector<Subject> subjects;
  for (const Method& method : charted.methods) {
    subjects.push_back(method.subject);
  }
  subjects.insert(subjects.end(), charted.others.begin(), charted.others.end());
  return subjects;
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
  if (methods.empty()) {
    return {};
  }
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
    result.push_back({method.subject.name,
                      method.subject.summary,
                      method.subject.law,
                      method.subject.precision,
                      {},
                      method.form == subjects::MethodForm::batch});
  }
  chart::ChartedSubjects charted(subjects_of({methods, {}, {}}));
  for (std::size_t f = 0; f < families.size(); ++f) {
    std::vector<Exactness> exactness = chart::measured_exactness(
        charted, families[f].collisions, oracles::default_limit_ulps, workers, chart::AnswersOfCoulomb::found);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      result[m].families.push_back(
          {std::string(families[f].family->name), std::move(exactness[m]), times[m * families.size() + f]});
    }
  }
  return result;
}

std::vector<report::SweepMeasurement> measured_sweeps(const ChartArguments& arguments, chart::ChartedSubjects& charted,
                                                      const properties::Workers& workers, const std::stop_token& stop) {
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
    for (const Subject& subject : charted.subjects()) {
      measurement.lines.push_back({subject.name, subject.law, subject.precision, sweep.quantities(), {}});
    }
    for (const double quantity : sweep.quantities()) {
      if (stop.stop_requested()) {
        throw UsageError("interrupted: no chart was written");
      }
      const std::vector<Collision> collisions =
          chart::colliding_cases(sweep, quantity, arguments.seed, arguments.cases);
      const std::vector<Exactness> exactness = chart::measured_exactness(
          charted, collisions, oracles::default_limit_ulps, workers, chart::AnswersOfCoulomb::left_out);
      for (std::size_t s = 0; s < exactness.size(); ++s) {
        measurement.lines[s].exactness.push_back(exactness[s]);
      }
      if (progress) {
        progress(++done, all);
      }
    }
    result.push_back(std::move(measurement));
  }
  return result;
}

/// Whether a line of the sweep has the law.
bool has_law(const report::SweepMeasurement& sweep, Law law) {
  return std::ranges::any_of(sweep.lines, [&](const report::SweepLine& line) { return line.law == law; });
}

/// All pictures but those of deadlines show backward errors, which a law has if it determines the outcome.
std::vector<report::Plot> pictures_of(const report::Measurements& measurements) {
  std::vector<report::Plot> pictures;
  for (const Law law : report::charted_laws()) {
    const std::vector<MethodMeasurement> methods = report::of_law(measurements.methods, law);
    if (!methods.empty()) {
      if (determines_outcome(law)) {
        pictures.push_back(report::work_precision(methods, measurements.limit_ulps));
      }
      pictures.push_back(report::deadline(methods));
    }
    for (const report::SweepMeasurement& sweep : measurements.sweeps) {
      if (determines_outcome(law) && has_law(sweep, law)) {
        pictures.push_back(report::stability_map(sweep, law, measurements.limit_ulps));
      }
    }
  }
  return pictures;
}

int chart_subjects(const ChartArguments& arguments) {
  const Charted charted = charted_by(arguments);
  StagedOutput staged(arguments.out);
  const properties::Workers workers = threads(arguments.jobs);
  chart::ChartedSubjects in_sweeps(subjects_of(charted), charted.stop);
  const report::Measurements measurements{this_environment(),
                                          arguments.seed,
                                          arguments.cases,
                                          arguments.repetitions,
                                          oracles::default_limit_ulps,
                                          measured_methods(arguments, charted.methods, workers),
                                          measured_sweeps(arguments, in_sweeps, workers, charted.stop)};
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
  fmt::print("{}", tables);
  if (undrawn) {
    std::fflush(stdout);
    std::rethrow_exception(undrawn);
  }
  if (!in_sweeps.failure().empty()) {
    std::fflush(stdout);
    throw UsageError(report::shown(in_sweeps.failure() + "; the chart has no later points of this subject"));
  }
  in_sweeps.close();
  return exit_all_hold;
}

}  // namespace

void add_chart(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<ChartArguments>();
  CLI::App* command = app.add_subcommand(
      "chart", "Measure the speed and the accuracy of methods, or the accuracy of other subjects, and draw charts");
  command->add_option("SUBJECT", arguments->subjects,
                      "Methods (solvers of carom/impulse), or other subjects: a built-in name, or 'exec:PROGRAM ARG…'. "
                      "Only methods are timed (default: all methods)");
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
  add_timeout(*command, arguments->timeout);
  command->callback([&chosen, arguments] { chosen = [arguments] { return chart_subjects(*arguments); }; });
}

}  // namespace carom::tool
