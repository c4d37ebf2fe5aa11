// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/present_run.hpp"

#include <cstdio>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "commands/output_file.hpp"
#include "compare/comparison.hpp"
#include "report/html_report.hpp"
#include "report/junit.hpp"
#include "report/table.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

/// The run beside its baseline, as report.json has it.
compare::Comparison against_baseline(const GateRun& run, const compare::ReadReport& baseline) {
  const std::string text = report_record(run).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return compare::compare_reports(baseline, compare::report_from_json(nlohmann::json::parse(text), "this run"));
}

void write_reports(const GateRun& run, const std::string& out) {
  // First of all what lists the witnesses: a later run removes those that are listed.
  write_file(fs::path(out) / "report.json",
             report_record(run).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
  for (const properties::SubjectResult& result : run.report.results) {
    for (const properties::Witness& witness : result.witnesses) {
      const fs::path path = witness_path(out, result.subject, witness);
      write_file(path, witness_record(witness, result.subject, run.report.options, path)
                               .dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
                           '\n');
    }
  }
  write_file(fs::path(out) / "junit.xml", junit_xml(run));
  write_file(fs::path(out) / "report.html", html_report(run, out));
}

}  // namespace

int present_run(GateRun run, const std::optional<compare::ReadReport>& baseline, const std::string& out,
                const std::string& format) {
  if (baseline) {
    run.baseline = against_baseline(run, *baseline);
  }
  if (format == "json") {
    fmt::print("{}\n", report_record(run).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    fmt::print("{}", report_text(run, out));
  }
  if (!out.empty()) {
    std::fflush(stdout);  // what was found is not lost where the files cannot be written
    write_reports(run, out);
  }
  return run.exit_status();
}

}  // namespace carom::tool
