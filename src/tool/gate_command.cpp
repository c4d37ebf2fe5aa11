// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include <carom/subjects/catalogue.hpp>

#include "commands.hpp"
#include "junit.hpp"
#include "records.hpp"
#include "table.hpp"

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
      throw UsageError(fmt::format("--families: there is no family '{}'; there are {}", name, known_names(names)));
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

Selection select(const GateArguments& arguments) {
  std::vector<Subject> wanted;
  for (const std::string& name : arguments.subjects) {
    const std::optional<Subject> subject = subjects::subject_named(name);
    if (!subject) {
      throw UsageError(fmt::format("there is no subject '{}'; `carom subjects` lists them", name));
    }
    const bool repeated = std::any_of(wanted.begin(), wanted.end(), [&](const Subject& s) { return s.name == name; });
    if (!repeated) {
      wanted.push_back(*subject);
    }
  }
  const bool named = !wanted.empty();
  if (!named) {
    wanted = subjects::all_subjects();
  }
  Selection selection;
  for (Subject& subject : wanted) {
    if (!subject.absent.empty()) {
      selection.absent.push_back(std::move(subject));
      continue;
    }
    selection.counts.push_back(named || subject.expected_to_pass);
    selection.subjects.push_back(std::move(subject));
  }
  return selection;
}

/// A line on standard error that is written over, where that is a terminal.
std::function<void(std::uint64_t, std::uint64_t)> progress_line() {
  if (isatty(STDERR_FILENO) == 0) {
    return {};
  }
  return [shown = std::uint64_t{101}](std::uint64_t done, std::uint64_t all) mutable {
    const std::uint64_t percent = 100 * done / all;
    if (percent != shown) {
      shown = percent;
      fmt::print(stderr, "\r{} of {} cases judged, {} %{}", done, all, percent, done == all ? "\n" : "");
      std::fflush(stderr);
    }
  };
}

void write_file(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    throw UsageError(fmt::format("--out: {} cannot be written", path.string()));
  }
}

void make_directory(const std::string& out) {
  const fs::path witnesses = fs::path(out) / "witnesses";
  std::error_code error;
  fs::create_directories(witnesses, error);
  if (error) {
    throw UsageError(fmt::format("--out: {} cannot be made: {}", witnesses.string(), error.message()));
  }
  // Witnesses of an earlier run would pass for this one's.
  for (const fs::directory_entry& entry : fs::directory_iterator(witnesses)) {
    if (entry.path().extension() == ".json") {
      fs::remove(entry.path());
    }
  }
}

void write_reports(const GateRun& run, const std::string& out) {
  for (const properties::SubjectResult& result : run.report.results) {
    for (const properties::Witness& witness : result.witnesses) {
      const fs::path path = witness_path(out, result.subject, witness);
      write_file(path, witness_record(witness, result.subject, run.report.options, path)
                               .dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
                           '\n');
    }
  }
  write_file(fs::path(out) / "report.json",
             report_record(run).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
  write_file(fs::path(out) / "junit.xml", junit_xml(run));
}

}  // namespace

int gate(const GateArguments& arguments) {
  Selection selection = select(arguments);
  properties::GateOptions options;
  options.seed = arguments.seed;
  options.cases = arguments.cases;
  options.families = families_of(arguments);
  options.yardstick.limit_ulps = arguments.limit_ulps;
  options.yardstick.digits = arguments.digits;
  options.jobs = arguments.jobs > 0 ? arguments.jobs : std::max(1U, std::thread::hardware_concurrency());
  options.progress = progress_line();
  if (!arguments.out.empty()) {
    make_directory(arguments.out);
  }
  const GateRun run{properties::run_gate(selection.subjects, options), selection.counts, selection.absent};
  if (!arguments.out.empty()) {
    write_reports(run, arguments.out);
  }
  if (arguments.format == "json") {
    fmt::print("{}\n", report_record(run).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    fmt::print("{}", report_text(run, arguments.out));
  }
  return run.exit_status();
}

}  // namespace carom::tool
