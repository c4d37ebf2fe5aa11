// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/exec.hpp>

#include "commands/commands.hpp"
#include "commands/family_argument.hpp"
#include "commands/interrupt.hpp"
#include "commands/orphans.hpp"
#include "commands/output_file.hpp"
#include "commands/present_run.hpp"
#include "commands/progress.hpp"
#include "commands/staged_output.hpp"
#include "commands/subject_argument.hpp"
#include "commands/workflow_commands.hpp"
#include "compare/read_report.hpp"
#include "io/threads.hpp"
#include "report/environment.hpp"
#include "report/records.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

std::vector<const properties::Family*> families_of(const GateArguments& arguments) {
  std::vector<const properties::Family*> families;
  if (arguments.families.empty()) {
    for (const properties::Family& family : properties::all_families()) {
      families.push_back(&family);
    }
    return families;
  }
  for (const std::string& name : arguments.families) {
    const properties::Family* family = &family_from_argument("--families", name);
    if (std::find(families.begin(), families.end(), family) == families.end()) {
      families.push_back(family);
    }
  }
  return families;
}

/// The subjects to judge: those named, which then all count, or all that there are, of which those count that are
/// expected to pass.
struct Selection {
  std::vector<Subject> subjects;
  std::vector<bool> counts;
  std::vector<Subject> absent;
};

std::set<std::string> known_file_names() {
  std::set<std::string> names;
  for (const Subject& known : subjects::known_subjects()) {
    names.insert(file_name_of(known.name));
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
      // A program may call itself what it likes: what is taken, or would be taken for another's file, is numbered.
      const std::string name = subject.name;
      for (int count = 2; !taken.insert(file_name_of(subject.name)).second; ++count) {
        subject.name = fmt::format("{} #{}", name, count);
      }
    }
    wanted.push_back(std::move(subject));
  }
  const bool named = !wanted.empty();
  if (arguments.engines) {
    for (Subject& engine : subjects::engine_subjects(subjects::protocol::exec_options(arguments.timeout, stop))) {
      if (!words.contains(engine.name)) {
        wanted.push_back(std::move(engine));
      }
    }
  } else if (!named) {
    wanted = subjects::all_subjects();
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

std::vector<std::string> known_deviations(const GateArguments& arguments) {
  std::vector<std::string> deviates;
  for (const std::string& text : arguments.deviates) {
    try {
      (void)properties::deviation_from(text);
    } catch (const std::invalid_argument& error) {
      throw UsageError(compare::shown(std::string("--deviates: ") + error.what()));
    }
    if (std::find(deviates.begin(), deviates.end(), text) == deviates.end()) {
      deviates.push_back(text);
    }
  }
  return deviates;
}

/// Has none of the subjects claim this.
void let_deviate(std::vector<Subject>& subjects, const std::vector<std::string>& deviates) {
  for (Subject& subject : subjects) {
    for (const std::string& text : deviates) {
      if (std::find(subject.deviates.begin(), subject.deviates.end(), text) == subject.deviates.end()) {
        subject.deviates.push_back(text);
      }
    }
  }
}

}  // namespace

int gate(const GateArguments& arguments) {
  const std::vector<std::string> deviates = known_deviations(arguments);
  std::optional<compare::ReadReport> baseline;
  if (!arguments.baseline.empty()) {
    baseline = compare::read_report(arguments.baseline);
  }
  if (!arguments.annotations.empty() && arguments.format != "text") {
    throw UsageError("--annotations: stand in the text alone, not with --format " + arguments.format);
  }
  if (!arguments.summary.empty()) {
    append_to_file("--summary", arguments.summary, "");
  }
  std::optional<WorkflowCommandsStopped> commands_stopped;
  if (!arguments.annotations.empty()) {
    commands_stopped.emplace();
  }
  const std::stop_token stop = stop_on_interrupt();
  const Orphanage orphanage;
  Selection selection = select(arguments, stop);
  let_deviate(selection.subjects, deviates);
  properties::GateOptions options;
  options.seed = arguments.seed;
  options.cases = arguments.cases;
  options.budget = arguments.budget;
  options.fail_fast = arguments.fail_fast;
  options.families = families_of(arguments);
  if (arguments.families.empty() && !arguments.budget && !arguments.fail_fast) {
    for (const properties::Family& family : properties::families_beyond_domain()) {
      options.beyond_domain.push_back(&family);
    }
  }
  options.yardstick.limit_ulps = arguments.limit_ulps;
  options.yardstick.digits = arguments.digits;
  options.yardstick.filtered = !arguments.exact;
  options.workers = threads(arguments.jobs);
  options.progress = progress_line(arguments.budget ? "ms of the budget spent" : "cases judged");
  options.stop = stop;
  options.relations_every = arguments.relations_every;
  if (arguments.shard) {
    if (arguments.cases < arguments.shard->of) {
      throw UsageError(fmt::format("--shard: {} cases of each family are too few for {} shards", arguments.cases,
                                   arguments.shard->of));
    }
    options.shard = *arguments.shard;
  }
  std::optional<StagedOutput> staged;
  if (!arguments.out.empty()) {
    make_directories(fs::path(arguments.out) / "witnesses");
    staged.emplace(arguments.out);
  }
  const Environment environment = this_environment();
  GateRun run{properties::run_gate(selection.subjects, options),
              selection.counts,
              selection.absent,
              environment,
              {},
              deviates,
              arguments.shard.has_value()};
  run.diagnoses = properties::diagnosis::diagnose_all(run.report);
  return present_run(std::move(run), baseline,
                     {arguments.out, arguments.format, !arguments.annotations.empty(), arguments.summary,
                      [&] { commands_stopped.reset(); }},
                     staged);
}

}  // namespace carom::tool
