// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/ways_on.hpp>
#include <carom/report/results/words.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/exec.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/interrupt.hpp"
#include "io/job_shard.hpp"
#include "io/output.hpp"
#include "io/reports.hpp"
#include "io/this_environment.hpp"
#include "io/threads.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

struct GateArguments {
  std::vector<std::string> subjects;
  std::vector<std::string> families;
  std::optional<properties::Domain> within = {};  // none: the domain that the subjects declare
  std::uint64_t seed = 1;
  std::uint64_t cases = properties::default_cases;
  std::optional<std::chrono::nanoseconds> budget;  // in place of `cases`
  bool fail_fast = false;
  LimitArguments judged;
  unsigned jobs = 0;        // 0: one for each core
  std::string out;          // a directory; empty for none
  std::string annotations;  // "github", or empty for none
  std::string summary;      // a file to append to; empty for none
  bool all = false;
  bool engines = false;
  std::uint64_t relations_every = 0;  // 0: the default of GateOptions
  double timeout = 5;                 // for each reply of a program [s]
  std::string format = "text";
  std::string baseline;               // a report.json, or the directory that holds it; empty for none
  std::vector<std::string> deviates;  // "invariant" or "invariant@family"
  std::string shard;                  // "I/N" or automatic_shard; empty for the whole
  bool coverage = false;
};

namespace fs = std::filesystem;

/// The subjects to judge. A subject counts for the exit status if the command line names it, or if it is expected to
/// pass.
struct Selection {
  std::vector<Subject> subjects;
  std::vector<bool> counts;
  std::vector<Subject> absent;
};

std::set<std::string> known_file_names() {
  std::set<std::string> names;
  for (const Subject& known : subjects::known_subjects()) {
    names.insert(report::file_name_of(known.name));
  }
  return names;
}

Selection select(const GateArguments& arguments, const std::stop_token& stop) {
  std::vector<Subject> wanted;
  std::set<std::string> words;
  std::set<std::string> taken = known_file_names();
  for (const std::string& word : arguments.subjects) {
    if (!words.insert(word).second) {
      continue;
    }
    Subject subject = subject_from_argument(word, arguments.timeout, stop);
    if (word.starts_with(subjects::protocol::exec_prefix)) {
      // A program chooses its own name. If another subject has the name, or the same file name, a number is appended.
      const std::string name = subject.name;
      for (int count = 2; !taken.insert(report::file_name_of(subject.name)).second; ++count) {
        subject.name = fmt::format("{} #{}", name, count);
      }
    }
    wanted.push_back(std::move(subject));
  }
  const auto add = [&](std::vector<Subject> more) {
    for (Subject& subject : more) {
      const auto has_its_name = [&](const Subject& one) { return one.name == subject.name; };
      if (std::ranges::none_of(wanted, has_its_name)) {
        wanted.push_back(std::move(subject));
      }
    }
  };
  const bool named = !wanted.empty();
  if (arguments.all) {
    add(subjects::all_subjects());
  }
  if (arguments.engines) {
    add(subjects::engine_subjects(subjects::protocol::exec_options(arguments.timeout, stop)));
  }
  if (!named && !arguments.all && !arguments.engines) {
    wanted = subjects::default_subjects();
  }
  Selection selection;
  for (Subject& subject : wanted) {
    if (!subject.absent.empty()) {
      selection.absent.push_back(std::move(subject));
      continue;
    }
    selection.counts.push_back(subject.expected_to_pass || words.contains(subject.name) ||
                               words.contains(subject.specification));
    selection.subjects.push_back(std::move(subject));
  }
  return selection;
}

/// The shard that is judged; none for the whole run. Throws UsageError.
std::optional<properties::Shard> shard_of(const GateArguments& arguments) {
  if (arguments.shard.empty()) {
    return std::nullopt;
  }
  const properties::Shard shard =
      arguments.shard == automatic_shard ? shard_of_job(variable_of_process) : *shard_from(arguments.shard);
  if (arguments.cases < shard.of) {
    throw UsageError(
        fmt::format("--shard: {} cases of each family are too few for {} shards; use fewer shards, or a larger --cases",
                    arguments.cases, shard.of));
  }
  return shard;
}

/// The directory of the reports; empty for none. All processes of a job have the same --out, so each shard that the job
/// determines has its own folder there.
std::string directory_of(const GateArguments& arguments, const std::optional<properties::Shard>& shard) {
  const bool has_folder = !arguments.out.empty() && arguments.shard == automatic_shard;
  return has_folder ? (fs::path(arguments.out) / folder_of(*shard)).string() : arguments.out;
}

properties::GateOptions options_of(const GateArguments& arguments, const properties::Domain& within,
                                   properties::PosedFamilies posed, const std::stop_token& stop) {
  properties::GateOptions options;
  options.seed = arguments.seed;
  options.cases = arguments.cases;
  options.budget = arguments.budget;
  options.fail_fast = arguments.fail_fast;
  options.families = std::move(posed.families);
  options.within = within;
  if (!arguments.budget && !arguments.fail_fast) {
    options.beyond_domain = std::move(posed.beyond_domain);
  }
  options.limits = arguments.judged.limits();
  options.workers = threads(arguments.jobs);
  options.progress = progress_line(arguments.budget ? "ms of the budget spent" : "cases judged");
  options.stop = stop;
  options.relations_every = arguments.relations_every;
  return options;
}

/// GitHub reads workflow commands from everything that a job prints. While an object of this class exists, GitHub reads
/// none.
class WorkflowCommandsStopped {
 public:
  WorkflowCommandsStopped() {
    std::random_device random;
    for (int word = 0; word < 4; ++word) {
      token_ += fmt::format("{:08x}", random());
    }
    std::fputs(("::stop-commands::" + token_ + '\n').c_str(), stdout);
    std::fflush(stdout);
  }
  ~WorkflowCommandsStopped() {
    std::fputs(("\n::" + token_ + "::\n").c_str(), stdout);
    std::fflush(stdout);
  }
  WorkflowCommandsStopped(const WorkflowCommandsStopped&) = delete;
  WorkflowCommandsStopped& operator=(const WorkflowCommandsStopped&) = delete;

 private:
  std::string token_;  // lets commands be read again; it is random, so no program can print it
};

int gate(const GateArguments& arguments) {
  const std::vector<std::string> deviates = known_deviations(arguments.deviates);
  const std::optional<properties::Shard> shard = shard_of(arguments);
  const std::string out = directory_of(arguments, shard);
  const std::optional<report::RecordedRun> baseline =
      arguments.baseline.empty() ? std::nullopt : std::optional(read_report(arguments.baseline));
  if (!arguments.annotations.empty() && arguments.format != "text") {
    throw UsageError("--annotations: this option needs --format text, found --format " + arguments.format);
  }
  if (!arguments.summary.empty()) {
    append_to_file("--summary", arguments.summary, "");
  }
  std::optional<WorkflowCommandsStopped> commands_stopped;
  if (!arguments.annotations.empty()) {
    commands_stopped.emplace();
  }
  const std::stop_token stop = stop_on_interrupt();
  Selection selection = select(arguments, stop);
  for (Subject& subject : selection.subjects) {
    let_deviate(subject, deviates);
  }
  const properties::Domain within = arguments.within ? *arguments.within : declared_domain(selection.subjects);
  properties::PosedFamilies posed = properties::posed_families(arguments.families, within, arguments.seed);
  properties::GateOptions options = options_of(arguments, within, posed, stop);
  options.shard = shard.value_or(properties::Shard{});
  // In text alone, a subject that does not count is a row of the table, without a cause and without witnesses.
  const bool is_text_alone = out.empty() && arguments.summary.empty() && !baseline && arguments.format == "text";
  if (is_text_alone) {
    options.explains = selection.counts;
  }
  std::optional<StagedOutput> staged;
  if (!out.empty()) {
    make_directories(fs::path(out) / "witnesses");
    staged.emplace(out);
  }
  properties::GateReport found = properties::run_gate(selection.subjects, options);
  properties::add_ways_on(found, selection.counts);
  report::Run run = report::diagnosed({std::move(found), this_environment(), deviates, posed.without_case,
                                       selection.counts, selection.absent, shard.has_value()});
  return present_run(std::move(run), baseline,
                     {out, arguments.format, !arguments.annotations.empty(), arguments.summary,
                      [&] { commands_stopped.reset(); }, arguments.coverage},
                     staged);
}

std::string is_duration(const std::string& text) {
  return report::duration_from(text) ? std::string() : std::string("expected ") + report::duration_form;
}

}  // namespace

void add_gate(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<GateArguments>();
  CLI::App* command = app.add_subcommand(
      "gate",
      "Judge subjects; exit status 0 all invariants hold, 1 an invariant is violated, 2 usage or environment error");
  command->add_option("SUBJECT", arguments->subjects,
                      "Subjects to judge: built-in names, or 'exec:PROGRAM ARG…' for a program that implements the "
                      "protocol (default: one solver of each law, the method of the note, and the installed engines "
                      "that are linked; subjects that are expected to fail do not count)");
  command->add_flag("--all", arguments->all, "Judge all built-in subjects");
  command->add_flag("--engines", arguments->engines, "Judge all installed engines");
  add_seed(*command, arguments->seed, "Seed of the cases; the same seed gives the same cases");
  CLI::Option* cases = command
                           ->add_option("--cases", arguments->cases,
                                        "Number of cases of each family; the weight of a family multiplies it")
                           ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}))
                           ->capture_default_str();
  command
      ->add_option_function<std::string>(
          "--budget", [arguments](const std::string& text) { arguments->budget = report::duration_from(text); },
          "Time limit in place of --cases, for example 500ms, 10s, 2m or 1h. The gate draws cases from all families in "
          "turn and starts with the families that find most violations. The report holds all judged cases. Shrinking "
          "takes additional time")
      ->check(is_duration)
      ->type_name("DURATION")
      ->excludes(cases);
  command->add_flag(
      "--fail-fast", arguments->fail_fast,
      "Stop judging a subject after its first violation. The run ends after a violation of every subject, or after the "
      "last case. The report holds the first violation of each subject, shrunk. It does not depend on --jobs");
  command
      ->add_option("--relations-every", arguments->relations_every,
                   "Judge each invariant that relates two collisions on every Nth case only; different invariants use "
                   "different cases (default: 1; for programs 4)")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}));
  command->add_option("--families", arguments->families, "Families of cases, separated by commas (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_within(*command, arguments->within);
  command->add_option(
      "--out", arguments->out,
      "Directory for the reports and for witnesses/; the files of an earlier report there are replaced");
  command
      ->add_option("--baseline", arguments->baseline,
                   "An earlier report.json, or its directory. Its violations count as known. The exit status is 0 if "
                   "there are no new violations")
      ->excludes("--fail-fast");  // the first violation may be a known one, and would hide a new one
  command
      ->add_option("--shard", arguments->shard,
                   "Judge one part of a run: every Nth case of each family, starting with the Ith. `carom merge` "
                   "combines all N parts into one report. With auto, the variables of a batch system decide I and "
                   "N (Slurm, Open MPI, Kubernetes, GitHub, GitLab), and the reports go to --out/shard-I-of-N")
      ->check(is_shard)
      ->type_name("I/N|auto")
      ->excludes("--budget")
      ->excludes("--fail-fast")
      ->excludes("--baseline");
  add_deviates(*command, arguments->deviates, "The report lists them as not claimed");
  command
      ->add_option("--annotations", arguments->annotations,
                   "Print the violations also as annotations in the format of this service")
      ->check(CLI::IsMember({"github"}));
  command->add_option("--summary", arguments->summary, "File to which a summary in Markdown is appended")
      ->type_name("FILE");
  command->add_flag("--coverage", arguments->coverage,
                    "Also print the cases of each family by kind of contact, the families with violations, and where "
                    "each subject fails beyond the claimed domain. report.html always has them");
  add_jobs(*command, arguments->jobs, "Number of threads");
  add_limits(*command, arguments->judged);
  add_timeout(*command, arguments->timeout);
  add_format(*command, arguments->format, {"text", "json"});
  command->callback([&chosen, arguments] { chosen = [arguments] { return gate(*arguments); }; });
}

}  // namespace carom::tool
