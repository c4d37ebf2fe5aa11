// SPDX-License-Identifier: BSL-1.0
#include "commands/present_run.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "commands/old_witnesses.hpp"
#include "commands/output_file.hpp"
#include "compare/comparison.hpp"
#include "report/annotations.hpp"
#include "report/html_report.hpp"
#include "report/junit.hpp"
#include "report/summary.hpp"
#include "report/table.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

std::string in_json(const nlohmann::json& record, int indent) {
  return record.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

/// The run beside its baseline, as report.json has it.
compare::Comparison against_baseline(const GateRun& run, const compare::ReadReport& baseline) {
  const std::string text = in_json(report_record(run), -1);
  return compare::compare_reports(baseline, compare::report_from_json(nlohmann::json::parse(text), "this run"));
}

/// All of them or none, and at every moment a report with the witnesses that it lists.
void write_reports(const GateRun& run, const std::string& out, StagedOutput& staged) {
  const fs::path& stage = staged.stage();
  make_directories(stage / "witnesses");
  for (const properties::SubjectResult& result : run.report.results) {
    for (const properties::Witness& witness : result.witnesses) {
      const fs::path place = witness_path(out, result.subject, witness);
      write_file(witness_path(stage, result.subject, witness),
                 in_json(witness_record(witness, result.subject, run.report.options, place), 2));
    }
  }
  write_file(stage / "junit.xml", junit_xml(run));
  write_file(stage / "report.html", html_report(run, out));
  write_file(stage / "report.json", in_json(report_record(run), 2));
  const std::vector<fs::path> old = old_witnesses(out);
  staged.put_in_place("report.json");
  remove_old_witnesses(out, old);
  remove_abandoned_stages(out);
}

void flush_output() {
  if (std::fflush(stdout) != 0) {
    throw UsageError("standard output cannot be written");
  }
}

void print_run(const GateRun& run, const Presentation& presentation) {
  fmt::print("{}", presentation.format == "json" ? in_json(report_record(run), 2) : report_text(run, presentation.out));
  flush_output();  // before anything is said on standard error
  if (presentation.has_annotations) {
    presentation.annotate();
    fmt::print("{}", github_annotations(run, presentation.out));
    flush_output();
  }
}

}  // namespace

int present_run(GateRun run, const std::optional<compare::ReadReport>& baseline, const Presentation& presentation,
                std::optional<StagedOutput>& staged) {
  if (baseline) {
    run.baseline = against_baseline(run, *baseline);
  }
  // First what lasts; and where that cannot be written, what was found is printed all the same.
  std::exception_ptr unwritten;
  try {
    if (staged) {
      write_reports(run, presentation.out, *staged);
    }
    if (!presentation.summary.empty()) {
      append_to_file("--summary", presentation.summary, markdown_summary(run, presentation.out));
    }
  } catch (...) {
    unwritten = std::current_exception();
  }
  staged.reset();
  try {
    print_run(run, presentation);
  } catch (const std::exception&) {
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
