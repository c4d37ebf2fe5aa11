// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <thread>

#include <fmt/format.h>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/exec.hpp>

#include "commands/commands.hpp"
#include "commands/interrupt.hpp"
#include "commands/nearest_name.hpp"
#include "commands/old_witnesses.hpp"
#include "commands/orphans.hpp"
#include "commands/output_file.hpp"
#include "commands/progress.hpp"
#include "commands/staged_output.hpp"
#include "commands/subject_argument.hpp"
#include "report/environment.hpp"
#include "report/html_report.hpp"
#include "report/junit.hpp"
#include "report/records.hpp"
#include "report/table.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

std::string known_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

std::vector<const properties::Family*> families_of(const GateArguments& arguments) {
  std::vector<const properties::Family*> families;
  if (arguments.families.empty()) {
    for (const properties::Family& family : properties::all_families()) {
      families.push_back(&family);
    }
    return families;
  }
  for (const std::string& name : arguments.families) {
    const properties::Family* family = properties::family_named(name);
    if (family == nullptr) {
      std::vector<std::string> names;
      for (const properties::Family& known : properties::all_families()) {
        names.emplace_back(known.name);
      }
      throw UsageError(fmt::format("--families: there is no family '{}'; there are {}{}", name, known_names(names),
                                   did_you_mean(name, names)));
    }
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

/// All of them or none, and at every moment a report with the witnesses that it lists.
void write_reports(const GateRun& run, const std::string& out, StagedOutput& staged) {
  const fs::path& stage = staged.stage();
  make_directories(stage / "witnesses");
  for (const properties::SubjectResult& result : run.report.results) {
    for (const properties::Witness& witness : result.witnesses) {
      write_file(witness_path(stage, result.subject, witness),
                 witness_record(witness, result.subject, run.report.options, witness_path(out, result.subject, witness))
                         .dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
                     '\n');
    }
  }
  write_file(stage / "junit.xml", junit_xml(run));
  write_file(stage / "report.html", html_report(run, out));
  write_file(stage / "report.json",
             report_record(run).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
  const std::vector<fs::path> old = old_witnesses(out);
  staged.put_in_place("report.json");
  remove_old_witnesses(out, old);
  remove_abandoned_stages(out);
}

void print_reports(const GateRun& run, const GateArguments& arguments) {
  if (arguments.format == "json") {
    fmt::print("{}\n", report_record(run).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    fmt::print("{}", report_text(run, arguments.out));
  }
  std::fflush(stdout);  // before anything is said on standard error
}

}  // namespace

int gate(const GateArguments& arguments) {
  const std::stop_token stop = stop_on_interrupt();
  const Orphanage orphanage;
  Selection selection = select(arguments, stop);
  properties::GateOptions options;
  options.seed = arguments.seed;
  options.cases = arguments.cases;
  options.budget = arguments.budget;
  options.fail_fast = arguments.fail_fast;
  options.families = families_of(arguments);
  options.yardstick.limit_ulps = arguments.limit_ulps;
  options.yardstick.digits = arguments.digits;
  options.yardstick.filtered = !arguments.exact;
  options.jobs = arguments.jobs > 0 ? arguments.jobs : std::max(1U, std::thread::hardware_concurrency());
  options.progress = progress_line(arguments.budget ? "ms of the budget spent" : "cases judged");
  options.stop = stop;
  options.relations_every = arguments.relations_every;
  std::optional<StagedOutput> staged;
  if (!arguments.out.empty()) {
    make_directories(fs::path(arguments.out) / "witnesses");
    staged.emplace(arguments.out);
  }
  const Environment environment = this_environment();
  const GateRun run{properties::run_gate(selection.subjects, options), selection.counts, selection.absent, environment};
  // First what lasts; and where that cannot be written, what was found is printed all the same.
  std::exception_ptr unwritten;
  if (staged) {
    try {
      write_reports(run, arguments.out, *staged);
    } catch (...) {
      unwritten = std::current_exception();
    }
    staged.reset();
  }
  try {
    print_reports(run, arguments);
  } catch (const std::system_error&) {
    if (!unwritten) {
      throw;
    }
  }
  if (unwritten) {
    std::rethrow_exception(unwritten);
  }
  return run.exit_status();
}

}  // namespace carom::tool
